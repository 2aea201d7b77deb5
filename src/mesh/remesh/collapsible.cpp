#include "mesh/remesh/collapsible.hpp"

#include <algorithm>

namespace fccda {
namespace {

std::size_t corner_of(const Triangle& triangle, int vertex) { return triangle.vertex[0] == vertex ? 0 : triangle.vertex[1] == vertex ? 1 : 2; }

bool has_corner(const Triangle& triangle, int vertex) { return triangle.vertex[corner_of(triangle, vertex)] == vertex; }

/// The edge between two of a triangle's vertices.
std::size_t edge_of(const Triangle& triangle, int one, int other) {
  const std::size_t a = corner_of(triangle, one), b = corner_of(triangle, other);
  return (a + 1) % 3 == b ? a : b;
}

}  // namespace

CollapsibleTriangles::CollapsibleTriangles(const Surface& surface)
    : vertices_(surface.vertices().begin(), surface.vertices().end()),
      triangles_(surface.triangles().begin(), surface.triangles().end()),
      triangle_at_(vertices_.size(), -1) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    beyond_.push_back({surface.neighbour(t, 0), surface.neighbour(t, 1), surface.neighbour(t, 2)});
    for (const int vertex : triangles_[t].vertex) triangle_at_[static_cast<std::size_t>(vertex)] = static_cast<int>(t);
  }
}

void CollapsibleTriangles::ring_of(int vertex, Ring& ring) const {
  ring.triangles.clear();
  ring.link.clear();
  // clockwise to the boundary, if there is one
  const auto any = static_cast<std::size_t>(triangle_at_[static_cast<std::size_t>(vertex)]);
  std::size_t first = any;
  ring.goes_round = false;
  while (true) {
    const int beyond = beyond_[first][corner_of(triangles_[first], vertex)];
    if (beyond < 0) break;
    first = static_cast<std::size_t>(beyond);
    if (first == any) {
      ring.goes_round = true;
      break;
    }
  }
  for (std::size_t at = first;;) {
    const std::size_t c = corner_of(triangles_[at], vertex);
    ring.triangles.push_back(at);
    ring.link.push_back(triangles_[at].vertex[(c + 1) % 3]);
    const int beyond = beyond_[at][(c + 2) % 3];
    if (beyond < 0) ring.link.push_back(triangles_[at].vertex[(c + 2) % 3]);
    if (beyond < 0 || static_cast<std::size_t>(beyond) == first) return;
    at = static_cast<std::size_t>(beyond);
  }
}

bool CollapsibleTriangles::may_collapse(int vertex, const Ring& ring, std::size_t to) {
  const std::size_t last = ring.link.size() - 1;
  if (!ring.goes_round && (ring.triangles.size() < 2 || (to != 0 && to != last))) return false;
  ring_of(ring.link[to], ring_of_target_);
  if (ring.triangles.size() == 3 && ring.goes_round && ring_of_target_.triangles.size() == 3) return false;
  std::size_t common = 0;
  for (const int other : ring_of_target_.link) common += other != vertex && std::find(ring.link.begin(), ring.link.end(), other) != ring.link.end();
  return common == (ring.goes_round ? 2u : 1u);
}

void CollapsibleTriangles::collapse(int vertex, const Ring& ring, std::size_t to) {
  const int target = ring.link[to];
  for (const std::size_t t : ring.triangles)
    if (has_corner(triangles_[t], target)) take(t, vertex, target);
  for (const std::size_t t : ring.triangles) {
    if (!has_triangle(t)) continue;
    triangles_[t].vertex[corner_of(triangles_[t], vertex)] = target;
    for (const int corner : triangles_[t].vertex) triangle_at_[static_cast<std::size_t>(corner)] = static_cast<int>(t);
  }
  triangle_at_[static_cast<std::size_t>(vertex)] = -1;
}

/// Removes a triangle between both vertices, and joins the neighbours beyond its two other edges.
void CollapsibleTriangles::take(std::size_t triangle, int vertex, int target) {
  Triangle& t = triangles_[triangle];
  const int third = t.vertex[3 - corner_of(t, vertex) - corner_of(t, target)];
  const int outer = beyond_[triangle][edge_of(t, target, third)], inner = beyond_[triangle][edge_of(t, vertex, third)];
  replace_neighbour(outer, static_cast<int>(triangle), inner);
  replace_neighbour(inner, static_cast<int>(triangle), outer);
  t.vertex = {-1, -1, -1};
}

void CollapsibleTriangles::replace_neighbour(int triangle, int old_one, int new_one) {
  if (triangle < 0) return;
  Neighbours& beyond = beyond_[static_cast<std::size_t>(triangle)];
  *std::find(beyond.begin(), beyond.end(), old_one) = new_one;
}

}  // namespace fccda
