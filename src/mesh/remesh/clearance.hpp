/// Clearance of a surface from itself: walls, gaps, blades.
#pragma once

#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

/// [m] By triangle: a third of the distance straight inward, and straight outward, to the next sheet, from the centroid and the corners; at
/// most `most`. If two sheets both move by no more than this, a third of their distance remains.
std::vector<double> clearance(const Surface& surface, double most);

}  // namespace fccda
