/// Triangles that know their neighbours, and the parts of a triangle that a closest point can lie on.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "fccda/core/vec3.hpp"

namespace fccda {

/// Half of a quad, or a whole triangular panel. Edge e goes from vertex[e] to vertex[(e + 1) % 3].
struct Triangle {
  std::array<int, 3> vertex;
  int panel;  ///< number of the panel it came from, as in the file
};

/// The triangles beyond the edges 0, 1, 2; -1 on a rim.
using Neighbours = std::array<int, 3>;

/// The part of a triangle that a closest point lies on.
enum class Feature : std::uint8_t { face, edge_0, edge_1, edge_2, vertex_0, vertex_1, vertex_2 };

struct LinkedTriangles {
  std::vector<Vec3d> vertices;  ///< [m]
  std::vector<Triangle> triangles;
  std::vector<Neighbours> neighbours;

  const Vec3d& corner(std::size_t triangle, std::size_t c) const { return vertices[static_cast<std::size_t>(triangles[triangle].vertex[c])]; }
};

/// Turns a triangle over. Its edges 0 and 2 change places.
inline void turn_over(Triangle& triangle, Neighbours& neighbours) {
  std::swap(triangle.vertex[1], triangle.vertex[2]);
  std::swap(neighbours[0], neighbours[2]);
}

}  // namespace fccda
