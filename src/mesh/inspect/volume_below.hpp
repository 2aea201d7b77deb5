/// Volume of a closed surface below the waterline.
#pragma once

#include "mesh/surface.hpp"

namespace fccda {

/// [m³] Volume of a closed surface below the plane z = height: the displacement of a ship with its waterline there. The shared volume of
/// overlapping components counts twice.
double volume_below(const Surface& surface, double height);

}  // namespace fccda
