#include "mesh/inspect/boundary_loops.hpp"

#include <algorithm>
#include <numeric>

namespace fccda {
namespace {

/// Disjoint sets of connected vertices (union–find).
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int v) {
    while (parent(v) != v) v = parent(v) = parent(parent(v));
    return v;
  }
  void join(int a, int b) { parent(root(a)) = root(b); }

 private:
  int& parent(int v) { return parent_[static_cast<std::size_t>(v)]; }
  std::vector<int> parent_;
};

template <class Visit>
void visit_boundary_edges(const Surface& surface, const Visit& visit) {
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    for (std::size_t e = 0; e < 3; ++e)
      if (surface.neighbour(t, e) < 0) visit(surface.triangles()[t].vertex[e], surface.triangles()[t].vertex[(e + 1) % 3]);
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const Surface& surface) {
  Sets sets(surface.vertices().size());
  visit_boundary_edges(surface, [&](int from, int to) { sets.join(from, to); });
  std::vector<int> number(surface.vertices().size(), -1);
  std::vector<BoundaryLoop> out;
  visit_boundary_edges(surface, [&](int from, int to) {
    int& loop_number = number[static_cast<std::size_t>(sets.root(from))];
    if (loop_number < 0) loop_number = static_cast<int>(out.size()), out.emplace_back();
    BoundaryLoop& loop = out[static_cast<std::size_t>(loop_number)];
    const Vec3d &a = surface.vertices()[static_cast<std::size_t>(from)], &b = surface.vertices()[static_cast<std::size_t>(to)];
    ++loop.edges;
    loop.length += norm(b - a);
    loop.bounds.include(a);
    loop.bounds.include(b);
  });
  std::stable_sort(out.begin(), out.end(), [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length > b.length; });
  return out;
}

}  // namespace fccda
