/// Fans: the triangles that hang together about a vertex, over edges. A vertex with several (two cones that touch at their tips) is
/// none of a manifold, and a pseudonormal averaged over all of them would say nothing.
#pragma once

#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// Gives each fan a vertex of its own, in the order of the triangles; vertices of no triangle go. Returns for each vertex whether it
/// lies on a rim. Expects consistent winding.
std::vector<bool> separate_fans(LinkedTriangles& surface);

}  // namespace fccda
