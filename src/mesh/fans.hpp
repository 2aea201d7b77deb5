/// Fans: triangles about a vertex that are connected over edges. A vertex with several fans (two cones that meet at their tips) is
/// non-manifold, and a pseudonormal averaged over all of them would be meaningless.
#pragma once

#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// Gives each fan its own vertex, in the order of the triangles, and removes unused vertices. Returns for each vertex whether it lies on a
/// boundary edge. Expects consistent winding.
std::vector<bool> separate_fans(LinkedTriangles& surface);

}  // namespace fccda
