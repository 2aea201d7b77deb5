/// Boundary loops of an open surface: unintended holes, or the end of a hull at its deck.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

/// Boundary edges connected over their vertices.
struct BoundaryLoop {
  std::size_t edges = 0;
  double length = 0;  ///< [m]
  Box bounds;         ///< [m]
};

/// All boundary loops, the longest first; none for a closed surface.
std::vector<BoundaryLoop> boundary_loops(const Surface& surface);

}  // namespace fccda
