/// A triangulation that stays manifold under successive edge collapses.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

/// The triangles about a vertex v, counterclockwise: (v, link[j], link[j + 1]).
struct Ring {
  std::vector<std::size_t> triangles;
  std::vector<int> link;
  bool goes_round;  ///< the last link is joined to the first; else v lies on the boundary, between the first link and the last

  std::size_t before(std::size_t j) const { return j > 0 ? j - 1 : link.size() - 1; }
  std::size_t after(std::size_t j) const { return j + 1 < link.size() ? j + 1 : 0; }
};

class CollapsibleTriangles {
 public:
  explicit CollapsibleTriangles(const Surface& surface);

  const Vec3d& place(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
  std::size_t vertex_count() const { return vertices_.size(); }     ///< including removed ones
  std::size_t triangle_count() const { return triangles_.size(); }  ///< including removed ones
  bool has_vertex(int vertex) const { return triangle_at_[static_cast<std::size_t>(vertex)] >= 0; }
  bool has_triangle(std::size_t triangle) const { return triangles_[triangle].vertex[0] >= 0; }
  const Triangle& triangle(std::size_t t) const { return triangles_[t]; }

  /// Expects an existing vertex. `ring` is overwritten.
  void ring_of(int vertex, Ring& ring) const;

  /// True if the collapse of v into link[to] preserves the manifold and its topology (link condition): the only common neighbours are those
  /// across the triangles of the edge between them, a tetrahedron is kept, and a vertex on the boundary moves along it (Dey, Edelsbrunner,
  /// Guha and Nekhayev, Publ. Inst. Math. Beograd 66 (1999) 23).
  bool may_collapse(int vertex, const Ring& ring, std::size_t to);

  /// Removes `vertex`: its triangles get link[to] in its place, and the one or two between both are removed.
  void collapse(int vertex, const Ring& ring, std::size_t to);

 private:
  void take(std::size_t triangle, int vertex, int target);
  void replace_neighbour(int triangle, int old_one, int new_one);

  std::vector<Vec3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Neighbours> beyond_;
  std::vector<int> triangle_at_;  // one triangle per vertex, -1 if the vertex was removed
  Ring ring_of_target_;
};

}  // namespace fccda
