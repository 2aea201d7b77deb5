/// How far a surface may move before it meets itself: walls, gaps, blades.
#pragma once

#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

/// [m] By triangle: a third of the way straight inward, and straight outward, to where the surface is met again, from the middle and the
/// corners; at most `most`. Two sheets that both move by no more than this keep a third of what is between them.
std::vector<double> clearance(const Surface& surface, double most);

}  // namespace fccda
