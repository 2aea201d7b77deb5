/// Self-intersections of a surface, and whether they affect contact.
///
/// Overlapping parts, such as blades embedded in a hub, are no defect: the surface is that of their union (search/solids.hpp). A crossing
/// within one body is a fold. Let w be the winding number of the body about a point. Two intersecting panels divide their surroundings into
/// four: outside both, inside either, inside both; w grows by one with each panel passed from its front. Where w is 0 or more outside both,
/// the body overlaps itself, and particles from outside still meet front faces. Where it is -1, the panels enclose a pocket with their backs
/// to the outside, and a particle could enter it without crossing a front: the surface is inside out there.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/defects.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct SelfIntersections {
  std::size_t crossings = 0;    ///< pairs of intersecting triangles of one body, or of an open surface
  std::vector<Defect> defects;  ///< at most one of self_intersection and one of inside_out; empty without crossings
};

/// Tests every pair of triangles whose boxes intersect (crossing_triangles.hpp: an edge exactly in the plane of the other triangle is
/// contact, not a crossing). For a closed body, a ray determines w at every crossing; for an open one it is unknown. Memory grows with the
/// surface, not with the crossings. `bvh` must contain all triangles of `surface`.
SelfIntersections self_intersections(const Surface& surface, const Bvh& bvh);

/// Throws SurfaceError if there are panels that are inside out; `name` as in Surface::Options.
void expect_no_pockets(const SelfIntersections& found, const std::string& name);

}  // namespace fccda
