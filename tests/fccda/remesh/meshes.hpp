/// What refined and coarsened panels are compared by: measures that share nothing with the library but Vec3 and the surface's report.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "fccda/surface/surface.hpp"
#include "fixtures/surfaces.hpp"

namespace fixtures {

using Triangle3 = std::array<Vec3d, 3>;

inline std::vector<Triangle3> triangles_of(const Panels& panels) {
  std::vector<Triangle3> out;
  for_each_triangle(panels, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { out.push_back({a, b, c}); });
  return out;
}

inline double longest_edge(const Triangle3& t) { return std::max({norm(t[1] - t[0]), norm(t[2] - t[1]), norm(t[0] - t[2])}); }

inline double area(const Triangle3& t) { return 0.5 * norm(cross(t[1] - t[0], t[2] - t[0])); }

/// [rad]
inline double smallest_angle(const Triangle3& t) {
  double smallest = 4;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3d u = t[(c + 1) % 3] - t[c], v = t[(c + 2) % 3] - t[c];
    smallest = std::min(smallest, std::atan2(norm(cross(u, v)), dot(u, v)));
  }
  return smallest;
}

inline fccda::Surface surface_from(const Panels& panels) { return fccda::Surface(panels, {.outside = fccda::OutsideIs::normals}); }

/// Vertices put elsewhere by up to `share` of the size of the panels about them, the same for the same seed.
inline Panels shaken(Panels panels, double share, unsigned seed) {
  std::mt19937_64 random(seed);
  for (Vec3d& vertex : panels.vertices) vertex += random_in_box(random, {-share, -share, -share}, {share, share, share});
  return panels;
}

/// A square plate in z = 0 of thin, askew triangles: a lattice whose inner vertices are shaken, then stretched along x.
inline Panels askew_plate(int cells, double stretch, unsigned seed) {
  std::mt19937_64 random(seed);
  Panels out;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && i < cells && j > 0 && j < cells;
      const Vec3d by = inner ? random_in_box(random, {-0.3, -0.3, 0}, {0.3, 0.3, 0}) : Vec3d{};
      out.vertices.push_back({stretch * (i + by.x) / cells, (j + by.y) / cells, 0});
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i;
      out.add_triangle(a, a + 1, a + cells + 2);
      out.add_triangle(a, a + cells + 2, a + cells + 1);
    }
  return out;
}

}  // namespace fixtures
