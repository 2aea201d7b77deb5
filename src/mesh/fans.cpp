#include "mesh/fans.hpp"

namespace fccda {
namespace {

struct Corner {
  std::size_t triangle, c;
};

std::size_t corner_of(const Triangle& triangle, int vertex) { return triangle.vertex[0] == vertex ? 0 : triangle.vertex[1] == vertex ? 1 : 2; }

}  // namespace

FanVertices separate_fans(LinkedTriangles& surface) {
  const std::vector<Triangle> old = surface.triangles;
  for (Triangle& triangle : surface.triangles) triangle.vertex = {-1, -1, -1};
  std::vector<Vec3d> vertices;
  vertices.reserve(surface.vertices.size());
  FanVertices out;

  // Numbers the corners of one fan from `start`, across the edge that ends (or begins) at the vertex. False at a boundary edge.
  const auto walk = [&](Corner start, std::size_t edge_from_corner, int number) {
    const int vertex = old[start.triangle].vertex[start.c];
    for (Corner at = start;;) {
      surface.triangles[at.triangle].vertex[at.c] = number;
      const int beyond = surface.neighbours[at.triangle][(at.c + edge_from_corner) % 3];
      if (beyond < 0) return false;
      at.triangle = static_cast<std::size_t>(beyond);
      at.c = corner_of(old[at.triangle], vertex);
      if (at.triangle == start.triangle) return true;
    }
  };
  constexpr std::size_t edge_that_begins = 0, edge_that_ends = 2;

  for (std::size_t t = 0; t < old.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (surface.triangles[t].vertex[c] >= 0) continue;
      const int number = static_cast<int>(vertices.size());
      vertices.push_back(surface.vertices[static_cast<std::size_t>(old[t].vertex[c])]);
      out.former.push_back(old[t].vertex[c]);
      const bool goes_round = walk({t, c}, edge_that_ends, number);
      if (!goes_round) walk({t, c}, edge_that_begins, number);
      out.on_rim.push_back(!goes_round);
    }
  }
  surface.vertices = std::move(vertices);
  return out;
}

}  // namespace fccda
