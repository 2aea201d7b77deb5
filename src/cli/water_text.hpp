/// A body that floats as text, for `check`.
#pragma once

#include <string>

#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// The characteristic length of each sheet on water, and the water that it entrains; empty for bodies that are no sheets or do not float.
std::string water_text(const Simulation& simulation, std::size_t body);

}  // namespace perimpact
