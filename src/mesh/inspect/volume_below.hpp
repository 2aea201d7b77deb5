/// How much of a closed surface lies under water.
#pragma once

#include "mesh/surface.hpp"

namespace fccda {

/// [m³] enclosed by a closed surface below the plane z = height: the displacement of a ship whose waterline is there. What overlapping components
/// share counts twice.
double volume_below(const Surface& surface, double height);

}  // namespace fccda
