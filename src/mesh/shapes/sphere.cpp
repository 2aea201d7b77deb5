#include "mesh/shapes/sphere.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/shapes/divisions.hpp"

namespace fccda {
namespace {

constexpr double edge = 2;  // of the icosahedron with the corners below

std::array<Vec3d, 12> icosahedron() {
  constexpr double golden = std::numbers::phi;
  std::array<Vec3d, 12> corners;
  std::size_t next = 0;
  for (const double one : {-1.0, 1.0}) {
    for (const double g : {-golden, golden}) {
      corners[next++] = {0, one, g};
      corners[next++] = {one, g, 0};
      corners[next++] = {g, 0, one};
    }
  }
  return corners;
}

/// Subdivides faces into f² triangles; vertices on common edges are created once.
class Subdivision {
 public:
  Subdivision(int f, double radius) : f_(f), radius_(radius), corners_(icosahedron()) {
    for (const Vec3d& corner : corners_) add_vertex(corner);
  }

  /// Oriented as its corners a, b, c.
  void add_face(int a, int b, int c) {
    // rows parallel to ab, the last one the corner c
    std::vector<int> row = edge_vertices(a, b);
    const std::vector<int> left = edge_vertices(a, c), right = edge_vertices(b, c);
    for (int r = 1; r <= f_; ++r) {
      const auto at = static_cast<std::size_t>(r);
      std::vector<int> next{left[at]};
      for (int k = 1; k < f_ - r; ++k) next.push_back(add_vertex((corner(a) * double(f_ - r - k) + corner(b) * double(k) + corner(c) * double(r))));
      if (r < f_) next.push_back(right[at]);
      for (std::size_t k = 0; k + 1 < row.size(); ++k) {
        out.add_triangle(row[k], row[k + 1], next[k]);
        if (k + 1 < next.size()) out.add_triangle(row[k + 1], next[k + 1], next[k]);
      }
      row = std::move(next);
    }
  }

  Panels out;

 private:
  const Vec3d& corner(int c) const { return corners_[static_cast<std::size_t>(c)]; }

  int add_vertex(const Vec3d& direction) {
    out.vertices.push_back(radius_ / norm(direction) * direction);
    return static_cast<int>(out.vertices.size()) - 1;
  }

  /// From a to b, both included.
  std::vector<int> edge_vertices(int a, int b) {
    if (a > b) {
      const std::vector<int> turned = edge_vertices(b, a);
      return {turned.rbegin(), turned.rend()};
    }
    std::vector<int>& vertices = edges_[{a, b}];
    if (vertices.empty()) {
      vertices.push_back(a);
      for (int k = 1; k < f_; ++k) vertices.push_back(add_vertex(corner(a) * double(f_ - k) + corner(b) * double(k)));
      vertices.push_back(b);
    }
    return vertices;
  }

  int f_;
  double radius_;
  std::array<Vec3d, 12> corners_;
  std::map<std::pair<int, int>, std::vector<int>> edges_;
};

}  // namespace

Panels make_sphere(const SphereShape& shape) {
  expect_sizes({shape.diameter}, shape.edge_length, "sphere");
  const double panel = shape.edge_length > 0 ? shape.edge_length : shape.diameter / 20;
  const double radius = 0.5 * shape.diameter;
  // distance of the faces: φ²/√3 for edges of length 2
  constexpr double distance = std::numbers::phi * std::numbers::phi * std::numbers::inv_sqrt3;
  const double f = divisions(edge / distance * radius, panel);
  expect_affordable(20 * f * f, panel, "sphere");

  Subdivision sphere(static_cast<int>(f), radius);
  const std::array<Vec3d, 12> corners = icosahedron();
  const auto are_joined = [&](std::size_t a, std::size_t b) { return norm(corners[a] - corners[b]) < 1.1 * edge; };  // the next distance is φ times as large
  for (std::size_t a = 0; a < 12; ++a) {
    for (std::size_t b = a + 1; b < 12; ++b) {
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (!are_joined(a, b) || !are_joined(b, c) || !are_joined(c, a)) continue;
        const bool outward = dot(cross(corners[b] - corners[a], corners[c] - corners[a]), corners[a]) > 0;
        sphere.add_face(static_cast<int>(a), static_cast<int>(outward ? b : c), static_cast<int>(outward ? c : b));
      }
    }
  }
  return std::move(sphere.out);
}

}  // namespace fccda
