/// Closed parts of a surface that may overlap: what they share counts twice in volume and inertia, which are sums over the parts.
#pragma once

#include <cstddef>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// How many components of positive volume have a bounding box that meets the box of another such one. Boxes are a hint, not a proof: a
/// pair that is counted need not overlap, one that is not counted does not. Cavities (negative volume) belong inside of others and do
/// not count. Expects outward winding.
std::size_t components_that_may_overlap(const LinkedTriangles& surface, const Components& components);

}  // namespace fccda
