/// The lines of output.lines: which particles they follow, and at which steps they are written.
#pragma once

#include <string>
#include <vector>

#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

struct Line {
  std::string name;
  std::size_t body;  ///< index
  std::vector<Sample> samples;
  std::vector<long> steps;  ///< at which to write it
};

/// Throws SetupError where a line leaves its body, or is wanted after the end of the run.
std::vector<Line> lines_of(const Simulation& simulation);

}  // namespace perimpact
