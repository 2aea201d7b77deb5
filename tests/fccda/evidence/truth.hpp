/// Reference solution for points and paths near a closed surface, by loops over all of its triangles: side, distance, crossings.
/// It shares nothing with the library but Vec3, and uses the corners alone. Two measures make it fast enough for a hundred thousand queries:
/// bounding balls of the triangles are compared first, and the winding number is counted along rays of one direction.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "fccda/detect/scene.hpp"

namespace evidence {

using namespace fccda;
using fixtures::Soup;

/// Rotation by |rotation| [rad] about the direction of `rotation`; Rodrigues' formula.
inline Vec3d turned(const Vec3d& vector, const Vec3d& rotation) {
  const double angle = norm(rotation);
  if (angle == 0) return vector;
  const Vec3d axis = rotation / angle;
  return std::cos(angle) * vector + std::sin(angle) * cross(axis, vector) + (1 - std::cos(angle)) * dot(axis, vector) * axis;
}

class Truth {
 public:
  explicit Truth(const Surface& surface) : soup_(surface) {
    for (const auto& t : soup_.triangles) {
      const Vec3d middle = (t[0] + t[1] + t[2]) / 3;
      balls_.push_back({middle, std::max({norm(t[0] - middle), norm(t[1] - middle), norm(t[2] - middle)})});
      std::array<Vec3d, 3> seen;
      for (std::size_t c = 0; c < 3; ++c) seen[c] = along_rays(t[c]);
      shadows_.push_back({min(min(seen[0], seen[1]), seen[2]), max(max(seen[0], seen[1]), seen[2]), seen});
    }
  }

  const Soup& soup() const { return soup_; }

  /// By the signed crossings of a ray from the point; if it passes within 1e-9 of an edge, by the sum of solid angles.
  bool inside(const Vec3d& point) const {
    const Vec3d p = along_rays(point);
    int winding = 0;
    for (const Shadow& shadow : shadows_) {
      if (p.x < shadow.low.x || p.x > shadow.high.x || p.y < shadow.low.y || p.y > shadow.high.y || p.z > shadow.high.z) continue;
      std::array<double, 3> area;
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3d a = shadow.corner[c] - p, b = shadow.corner[(c + 1) % 3] - p;
        area[c] = a.x * b.y - a.y * b.x;
        if (std::fabs(area[c]) < 1e-12) return soup_.inside(point);
      }
      if ((area[0] > 0) != (area[1] > 0) || (area[1] > 0) != (area[2] > 0)) continue;
      const double height = (area[1] * shadow.corner[0].z + area[2] * shadow.corner[1].z + area[0] * shadow.corner[2].z) / (area[0] + area[1] + area[2]) - p.z;
      if (std::fabs(height) < 1e-9) return soup_.inside(point);
      if (height > 0) winding += area[0] > 0 ? 1 : -1;
    }
    return winding > 0;
  }

  double distance(const Vec3d& point) const { return distance(Path{point, point}); }

  /// Least distance of a path from the surface.
  double distance(const Path& path) const {
    const Vec3d middle = path.at(0.5);
    const double half = 0.5 * path.length();
    std::size_t nearest = 0;
    double square = std::numeric_limits<double>::max();
    for (std::size_t t = 0; t < balls_.size(); ++t) {
      const double its = squared_norm(balls_[t].middle - middle);
      if (its < square) square = its, nearest = t;
    }
    double least = Soup::distance(middle, soup_.triangles[nearest]);
    for (std::size_t t = 0; t < balls_.size(); ++t) {
      const double reach = least + half + balls_[t].radius;
      if (squared_norm(balls_[t].middle - middle) >= reach * reach) continue;
      least = std::min(least, half == 0 ? Soup::distance(middle, soup_.triangles[t]) : distance(path, soup_.triangles[t]));
    }
    return least;
  }

  struct Crossing {
    std::size_t triangle = 0;
    double fraction = 0;  ///< of the path
    double margin = 0;    ///< margin inside the triangle: the least of its barycentric coordinates there
  };

  /// The first crossing of the path with a triangle, from its front or its back; undecided crossings of edges count, with margin 0.
  std::optional<Crossing> first_crossing(const Path& path) const {
    const Vec3d middle = path.at(0.5), way = path.end - path.start;
    const double half = 0.5 * path.length();
    std::optional<Crossing> first;
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      const double reach = balls_[k].radius + half;
      if (squared_norm(balls_[k].middle - middle) > reach * reach) continue;
      const auto& t = soup_.triangles[k];
      const Vec3d area = cross(t[1] - t[0], t[2] - t[0]);
      const double start = dot(area, path.start - t[0]), end = dot(area, path.end - t[0]);
      if ((start > 0) == (end > 0)) continue;
      const double fraction = start / (start - end);
      const Vec3d place = path.start + fraction * way;
      double margin = 1;
      for (std::size_t c = 0; c < 3; ++c) margin = std::min(margin, dot(area, cross(t[c] - place, t[(c + 1) % 3] - place)) / dot(area, area));
      if (margin < -1e-12) continue;
      if (!first || fraction < first->fraction) first = Crossing{k, fraction, margin};
    }
    return first;
  }

 private:
  struct Ball {
    Vec3d middle;
    double radius;
  };
  struct Shadow {  // of a triangle, along the rays
    Vec3d low, high;
    std::array<Vec3d, 3> corner;
  };

  /// In axes whose z is the direction of all rays, which lies in the plane of no panel.
  static Vec3d along_rays(const Vec3d& p) {
    static const Vec3d odd{0.6154, -0.9271, 0.3217}, x = turned({1, 0, 0}, odd), y = turned({0, 1, 0}, odd), z = turned({0, 0, 1}, odd);
    return {dot(x, p), dot(y, p), dot(z, p)};
  }

  /// The distance from a triangle is a convex function along the path, so golden-section search finds its minimum.
  static double distance(const Path& path, const std::array<Vec3d, 3>& triangle) {
    const double section = (std::sqrt(5.0) - 1) / 2;
    double low = 0, high = 1;
    const auto at = [&](double fraction) { return Soup::distance(path.at(fraction), triangle); };
    double a = high - section, b = low + section, at_a = at(a), at_b = at(b);
    for (int k = 0; k < 50; ++k) {
      if (at_a < at_b) {
        high = b, b = a, at_b = at_a;
        a = high - section * (high - low), at_a = at(a);
      } else {
        low = a, a = b, at_a = at_b;
        b = low + section * (high - low), at_b = at(b);
      }
    }
    return std::min({at_a, at_b, at(0), at(1)});
  }

  Soup soup_;
  std::vector<Ball> balls_;
  std::vector<Shadow> shadows_;
};

}  // namespace evidence
