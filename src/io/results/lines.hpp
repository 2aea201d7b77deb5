/// The sampling lines of output.lines: the particles they follow and the steps at which they are written.
#pragma once

#include <string>
#include <vector>

#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

struct Line {
  std::string name;
  std::size_t body;  ///< index
  std::vector<Sample> samples;
  std::vector<long> steps;  ///< steps at which it is written
};

/// The lines of the setup. Throws SetupError where a line leaves its body, or is requested after the end of the run.
std::vector<Line> lines_of(const Simulation& simulation);

}  // namespace perimpact
