#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace perimpact {

std::string duration_in_words(double seconds) {
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

Progress::Progress(const Simulation& simulation) : first_(simulation.clock().step), is_terminal_(isatty(STDOUT_FILENO) != 0) {}

double Progress::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

void Progress::after_step(const Simulation& simulation) { draw_if_due(simulation, simulation.clock().step); }

void Progress::in_increment(const Simulation& simulation) { draw_if_due(simulation, simulation.clock().step - 1); }

void Progress::draw_if_due(const Simulation& simulation, long done) {
  const double now = seconds();
  if (now - drawn_ >= (is_terminal_ ? 0.25 : 10.0)) draw(simulation, now, done);
}

void Progress::finish(const Simulation& simulation) {
  draw(simulation, seconds(), simulation.clock().step);
  if (is_terminal_) std::fputs("\n", stdout);
}

void Progress::draw(const Simulation& simulation, double now, long done) {
  const Clock& clock = simulation.clock();
  const double share = static_cast<double>(done) / static_cast<double>(clock.steps);
  const double rate = now > 0 ? static_cast<double>(done - first_) / now : 0;
  const double left = rate > 0 ? static_cast<double>(clock.steps - done) / rate : 0;
  const std::string line = simulation.relaxation()
                               ? fmt::format("{:5.1f} %  increment {} of {}  t = {:.4g} s  {} iterations  residual {:.2g}{}", 100 * share, clock.step,
                                             clock.steps, clock.time(), simulation.relaxation()->latest().iterations,
                                             simulation.relaxation()->latest().residual, rate > 0 ? "  " + duration_in_words(left) + " left" : "")
                               : fmt::format("{:5.1f} %  step {} of {}  t = {:.4g} s  {:.3g} steps/s  {} left  {} contacts", 100 * share, clock.step,
                                             clock.steps, clock.time(), rate, duration_in_words(left), simulation.contacts());
  // unlike fmt::print, fputs does not throw if the output is lost, which must not end a run
  std::fputs((is_terminal_ ? "\r\033[K" + line : line + "\n").c_str(), stdout);
  std::fflush(stdout);
  drawn_ = now;
}

}  // namespace perimpact
