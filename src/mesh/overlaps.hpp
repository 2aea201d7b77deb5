/// Closed parts of a surface that may overlap: their shared volume counts twice in volume and inertia, which are sums over the parts.
#pragma once

#include <cstddef>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// The number of components of positive volume whose bounding box intersects that of another. Boxes give an upper bound: a counted pair
/// need not overlap, and a pair not counted does not. Cavities (negative volume) lie inside others by nature and are not counted. Expects
/// outward winding.
std::size_t components_that_may_overlap(const LinkedTriangles& surface, const Components& components);

}  // namespace fccda
