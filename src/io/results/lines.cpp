#include "io/results/lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

std::size_t body_named(const Simulation& simulation, const std::string& name, const std::string& key) {
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b)
    if (simulation.bodies()[b].name == name) return b;
  throw SetupError(key, fmt::format("body {} does not exist.", name));
}

Line line_of(const LineSetup& setup, const Simulation& simulation) {
  const Clock& clock = simulation.clock();
  const std::string key = "output.lines." + setup.name;
  const std::size_t b = body_named(simulation, setup.body, key + ".body");
  const Body& body = simulation.bodies()[b];
  Line line{setup.name, b, samples_along(body, setup.from, setup.to), {}};
  for (const Sample& sample : line.samples)
    if (sample.distance() > body.particles.spacing())
      throw SetupError(key, fmt::format("line {} runs outside body {} at ({:.4g}, {:.4g}, {:.4g}) m; move its ends into the body.", setup.name, setup.body,
                                        sample.at.x, sample.at.y, sample.at.z));
  for (const double time : setup.times) {
    const long step = std::lround(time / clock.dt);
    if (step > clock.steps)
      throw SetupError(key + ".times", fmt::format("line {} is requested at {:.4g} s, but the run ends at {:.4g} s.", setup.name, time,
                                                   static_cast<double>(clock.steps) * clock.dt));
    line.steps.push_back(step);
  }
  if (setup.times.empty()) line.steps.push_back(clock.steps);
  return line;
}

}  // namespace

std::vector<Line> lines_of(const Simulation& simulation) {
  std::vector<Line> lines;
  for (const LineSetup& line : simulation.setup().output.lines) lines.push_back(line_of(line, simulation));
  return lines;
}

}  // namespace perimpact
