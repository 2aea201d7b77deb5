/// The rims of an open surface: holes that nobody meant, or the end of a hull at its deck.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

/// Edges of one panel that hang together over their vertices.
struct BoundaryLoop {
  std::size_t edges = 0;
  double length = 0;  ///< [m]
  Box bounds;         ///< [m]
};

/// All rims, the longest first; none of a closed surface.
std::vector<BoundaryLoop> boundary_loops(const Surface& surface);

}  // namespace fccda
