#include "cli/progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace perimpact {

using output::Json;

std::string duration_in_words(double seconds) {
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

struct Progress::Reached {
  Json members;
  std::vector<Messages::Part> parts;
};

Progress::Progress(const Simulation& simulation, Messages& messages) : messages_(messages), first_(simulation.clock().step) {}

void Progress::after_step(const Simulation& simulation) {
  if (!messages_.is_progress_due()) return;
  const Reached now = reached(simulation, simulation.clock().step);
  messages_.progress(now.members, now.parts);
}

void Progress::in_increment(const Simulation& simulation) {
  if (!messages_.is_progress_due()) return;
  const Reached now = reached(simulation, simulation.clock().step - 1);
  messages_.progress(now.members, now.parts);
}

void Progress::finish(const Simulation& simulation) {
  const Reached now = reached(simulation, simulation.clock().step);
  messages_.end_progress(now.members, now.parts);
}

Progress::Reached Progress::reached(const Simulation& simulation, long done) const {
  const Clock& clock = simulation.clock();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const double share = static_cast<double>(done) / static_cast<double>(clock.steps);
  const double rate = seconds > 0 ? static_cast<double>(done - first_) / seconds : 0;
  std::optional<double> left;  // [s]; unknown before the first step
  if (rate > 0) left = static_cast<double>(clock.steps - done) / rate;

  Reached now{Json::object(), {{fmt::format("{:5.1f} %", 100 * share), 9}}};
  now.members["share"] = share;
  now.members["time [s]"] = clock.time();
  const auto add = [&](int importance, std::string text) { now.parts.push_back({std::move(text), importance}); };
  if (const auto& relaxation = simulation.relaxation()) {
    const Relaxed& latest = relaxation->latest();
    now.members["increment"] = clock.step;
    now.members["increments"] = clock.steps;
    now.members["iterations"] = latest.iterations;
    now.members["residual"] = latest.residual;
    add(3, fmt::format("increment {} of {}", clock.step, clock.steps));
    add(2, fmt::format("t = {:.4g} s", clock.time()));
    add(1, fmt::format("{} iterations", latest.iterations));
    add(4, fmt::format("residual {:.2g}", latest.residual));
    if (left) add(5, duration_in_words(*left) + " left");
  } else {
    now.members["step"] = clock.step;
    now.members["steps"] = clock.steps;
    now.members["steps_per_second"] = rate;
    now.members["contacts"] = simulation.contacts();
    add(4, fmt::format("step {} of {}", clock.step, clock.steps));
    add(3, fmt::format("t = {:.4g} s", clock.time()));
    add(2, fmt::format("{:.3g} steps/s", rate));
    add(5, duration_in_words(left.value_or(0)) + " left");
    add(1, fmt::format("{} contacts", simulation.contacts()));
  }
  now.members["left [s]"] = left ? Json(*left) : Json();
  return now;
}

}  // namespace perimpact
