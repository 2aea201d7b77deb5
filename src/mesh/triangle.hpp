/// Triangles with adjacency, and the features of a triangle that a closest point can lie on.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Half of a quad, or a whole triangular panel. Edge e goes from vertex[e] to vertex[(e + 1) % 3].
struct Triangle {
  std::array<int, 3> vertex;  ///< vertex numbers
  int panel;                  ///< number of its panel, as in the file
};

/// The triangles beyond the edges 0, 1, 2; -1 at a boundary edge.
using Neighbours = std::array<int, 3>;

/// The feature of a triangle that a closest point lies on.
enum class Feature : std::uint8_t { face, edge_0, edge_1, edge_2, vertex_0, vertex_1, vertex_2 };

/// Triangles with shared vertices and their neighbours.
struct LinkedTriangles {
  std::vector<Vec3d> vertices;         ///< [m]
  std::vector<Triangle> triangles;     ///< by vertex numbers
  std::vector<Neighbours> neighbours;  ///< of each triangle

  /// Corner 0, 1 or 2 of a triangle [m].
  const Vec3d& corner(std::size_t triangle, std::size_t c) const { return vertices[static_cast<std::size_t>(triangles[triangle].vertex[c])]; }
};

/// The triangles with a boundary edge, one entry for each such edge.
inline std::vector<std::size_t> triangles_on_boundary(const LinkedTriangles& surface) {
  std::vector<std::size_t> out;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int beyond : surface.neighbours[t])
      if (beyond < 0) out.push_back(t);
  return out;
}

/// The panels of the numbered triangles, each once, in ascending order.
template <class Number>
std::vector<int> panels_of(std::span<const Triangle> triangles, const std::vector<Number>& numbers) {
  std::vector<int> panels;
  for (const Number t : numbers) panels.push_back(triangles[static_cast<std::size_t>(t)].panel);
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  return panels;
}

/// Reverses the winding of a triangle. Its edges 0 and 2 are exchanged.
inline void flip(Triangle& triangle, Neighbours& neighbours) {
  std::swap(triangle.vertex[1], triangle.vertex[2]);
  std::swap(neighbours[0], neighbours[2]);
}

}  // namespace fccda
