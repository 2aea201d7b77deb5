/// Edge adjacency of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// An edge shared by more than two triangles.
struct NonManifoldEdge {
  std::array<int, 2> vertices;  ///< the lower number first
  std::vector<int> triangles;   ///< in ascending order
};

struct Connection {
  std::size_t boundary_edges = 0;                     ///< edges of a single triangle
  std::vector<NonManifoldEdge> non_manifold_edges{};  ///< left without neighbours
};

/// Finds the neighbours across edges of two triangles. Expects triangles without repeated vertices.
Connection connect(LinkedTriangles& surface);

/// The non-manifold edges that could not be resolved, and their triangles, one entry per side that becomes a boundary edge.
struct Unjoined {
  std::vector<NonManifoldEdge> edges{};
  std::vector<std::size_t> triangles{};
};

/// Resolves non-manifold edges. Two triangles that are consecutive about the edge, with their fronts in the wedge between them, bound the
/// same outside, so they become neighbours. This connects parts that share an edge, and continues an outer wall past an inner wall that
/// ends at it. Expects consistent winding within each component; `fronts_are_backs` if all will be flipped.
Unjoined join_non_manifold(LinkedTriangles& surface, const std::vector<NonManifoldEdge>& non_manifold_edges, bool fronts_are_backs);

}  // namespace fccda
