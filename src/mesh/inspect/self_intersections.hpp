/// Where a surface goes through itself, and whether that matters.
///
/// Parts that overlap, as blades sunk in a hub do, are no defect: the surface is that of their union (search/solids.hpp). Within one body
/// a crossing is a fold. Say w is how often the body encloses a point. Two panels that cross divide their surroundings into four: outside
/// both, inside either, inside both, where w grows by one each time a panel is passed from its front. Where w is 0 or more outside both,
/// the body overlaps itself, and the panels that particles meet from outside still show them their fronts. Where it is -1 the panels turn
/// their backs to the outside around a pocket, and a particle could go in without touching a front: the surface is inside out there.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/defects.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct SelfIntersections {
  std::size_t crossings = 0;    ///< pairs of triangles of one body, or of an open surface, that cross
  std::vector<Defect> defects;  ///< at most one of self_intersection and one of inside_out; nothing where there are no crossings
};

/// Asks every pair of triangles whose boxes meet (crossing_triangles.hpp: where an edge of one lies exactly in the plane of the other,
/// they touch, and that is no crossing). Of a closed body w is told at every crossing, by a ray; of an
/// open one it is not known. Memory grows with the surface, not with the crossings. `surface` and `bvh` of all its triangles.
SelfIntersections self_intersections(const Surface& surface, const Bvh& bvh);

/// Throws SurfaceError where there are panels that are inside out; `name` as in Surface::Options.
void expect_no_pockets(const SelfIntersections& found, const std::string& name);

}  // namespace fccda
