/// Which triangles share an edge.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// An edge of more than two triangles.
struct NonManifoldEdge {
  std::array<int, 2> vertices;  ///< the lower number first
  std::vector<int> triangles;   ///< in rising order
};

struct Connection {
  std::size_t boundary_edges = 0;                     ///< edges with one triangle
  std::vector<NonManifoldEdge> non_manifold_edges{};  ///< left without neighbours
};

/// Finds the neighbours over edges of two triangles. Expects triangles without repeated vertices.
Connection connect(LinkedTriangles& surface);

/// What could not be joined: the edges, and the triangles, one entry for each side that is a rim now.
struct Unjoined {
  std::vector<NonManifoldEdge> edges{};
  std::vector<std::size_t> triangles{};
};

/// Goes round each crowded edge: two triangles that follow one another and have their fronts in the wedge between them bound the same
/// outside, so they become neighbours. Parts that touch along an edge hang together so, and an outer wall goes on past an inner one that
/// ends at it. Expects winding that is consistent within each component; `fronts_are_backs` where all will be turned over.
Unjoined join_non_manifold(LinkedTriangles& surface, const std::vector<NonManifoldEdge>& non_manifold_edges, bool fronts_are_backs);

}  // namespace fccda
