/// Measures of refined and coarsened panels that share nothing with the library but Vec3 and the surface's report.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "mesh/search/closest_point.hpp"
#include "mesh/surface.hpp"

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

inline fccda::Surface surface_from(const Panels& panels) { return fccda::Surface(panels, {.orientation = fccda::Orientation::normals}); }

/// Vertices displaced at random by up to `share` of the size of the panels about them, reproducible by the seed.
inline Panels shaken(Panels panels, double share, unsigned seed) {
  std::mt19937_64 random(seed);
  for (Vec3d& vertex : panels.vertices) vertex += random_in_box(random, {-share, -share, -share}, {share, share, share});
  return panels;
}

/// A square plate in z = 0 of thin, oblique triangles: a lattice with randomly displaced inner vertices, stretched along x.
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

/// [m] The largest distance from the triangles `from`, sampled densely, to the triangles `to`, by a loop over all. A lower bound of the Hausdorff distance.
inline double sampled_distance(const std::vector<Triangle3>& from, const std::vector<Triangle3>& to, int samples) {
  double largest = 0;
  for (const Triangle3& t : from)
    for (int i = 0; i <= samples; ++i)
      for (int j = 0; i + j <= samples; ++j) {
        const Vec3d point = (i * t[0] + j * t[1] + (samples - i - j) * t[2]) / static_cast<double>(samples);
        double nearest = 1e300;
        for (const Triangle3& other : to) {
          nearest = std::min(nearest, squared_norm(point - fccda::closest_on_triangle(point, {other[0], other[1], other[2]}).point));
          if (nearest <= largest * largest) break;
        }
        largest = fixtures::larger(largest, std::sqrt(nearest));
      }
  return largest;
}

/// Number of edges that cross the interior of another triangle: none for a surface without self-intersection.
inline std::size_t self_crossings(const std::vector<Triangle3>& triangles) {
  const auto volume = [](const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) { return dot(b - a, cross(c - a, d - a)); };
  const auto goes_through = [&](const Vec3d& p, const Vec3d& q, const Triangle3& t) {
    if (!(volume(p, t[0], t[1], t[2]) * volume(q, t[0], t[1], t[2]) < 0)) return false;
    const double u = volume(p, q, t[0], t[1]), v = volume(p, q, t[1], t[2]), w = volume(p, q, t[2], t[0]);
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
  };
  std::size_t count = 0;
  for (const Triangle3& one : triangles)
    for (const Triangle3& other : triangles) {
      const bool touch = std::any_of(one.begin(), one.end(), [&](const Vec3d& corner) { return std::find(other.begin(), other.end(), corner) != other.end(); });
      for (std::size_t e = 0; e < 3 && !touch; ++e) count += goes_through(one[e], one[(e + 1) % 3], other);
    }
  return count;
}

}  // namespace fixtures
