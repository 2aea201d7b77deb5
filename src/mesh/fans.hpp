/// Fans: triangles about a vertex that are connected over edges. A vertex with several fans (two cones that meet at their tips) is
/// non-manifold, and a pseudonormal averaged over all of them would be meaningless.
#pragma once

#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// Of each vertex after the separation of fans.
struct FanVertices {
  std::vector<bool> on_rim;   ///< it lies on a boundary edge
  std::vector<int> former{};  ///< its number before
};

/// Gives each fan its own vertex, in the order of the triangles, and removes unused vertices. Expects consistent winding.
FanVertices separate_fans(LinkedTriangles& surface);

}  // namespace fccda
