/// Deforming surfaces, points near them, and what contact they make, by loops over all triangles in numbers of 113 binary digits.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "fccda/deforming/deforming.hpp"
#include "fccda/deforming/exact_crossing.hpp"
#include "fccda/detect/scene.hpp"

namespace deforming {

using namespace fccda;
using fixtures::Soup;
using fixtures::TestPoints;

/// A way to deform a body about a unit in size, by an amount.
struct Deformation {
  const char* name;
  std::function<Vec3d(const Vec3d& x, double amount)> at;
};

inline std::vector<Deformation> deformations() {
  return {{"stretching",
           [](const Vec3d& x, double s) {
             return Vec3d{(1 + s) * x.x, (1 - 0.4 * s) * x.y, (1 - 0.4 * s) * x.z};
           }},
          {"bending",
           [](const Vec3d& x, double s) {
             return x + 4 * s * x.x * x.x * Vec3d{0, 0, 1};
           }},
          {"folding",
           [](const Vec3d& x, double s) {
             return x + 3 * s * std::fabs(x.x) * Vec3d{-0.3, 0.2, 1};
           }},
          {"spinning",
           [](const Vec3d& x, double s) {
             return Vec3d{std::cos(2 * s) * x.x - std::sin(2 * s) * x.y, std::sin(2 * s) * x.x + std::cos(2 * s) * x.y, x.z};
           }},
          {"twisting and moving", [](const Vec3d& x, double s) {
             const double angle = 4 * s * x.x;
             return Vec3d{x.x + 3 * s, std::cos(angle) * x.y - std::sin(angle) * x.z, std::sin(angle) * x.y + std::cos(angle) * x.z - s};
           }}};
}

inline std::vector<Vec3d> displaced(const Panels& panels, const Deformation& deformation, double amount) {
  std::vector<Vec3d> out;
  for (const Vec3d& x : panels.vertices) out.push_back(deformation.at(x, amount));
  return out;
}

/// An open square sheet of n × n quads with the front up, of size 1.
inline Panels sheet(int n) {
  Panels out;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) out.vertices.push_back({static_cast<double>(i) / n - 0.5, static_cast<double>(j) / n - 0.5, 0});
  const auto at = [&](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) out.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return out;
}

inline std::shared_ptr<DeformingSurface> open_surface(const Panels& panels) {
  return std::make_shared<DeformingSurface>(Surface(panels, {.orientation = Orientation::normals}));
}

/// Triangles near a path.
struct Near {
  const DeformingSurface& surface;
  std::vector<std::size_t> triangles;

  Near(const DeformingSurface& of, const Path& path, double reach) : surface(of) {
    Box way;
    way.include(path.start), way.include(path.end);
    for (std::size_t t = 0; t < surface.at_t1().triangles().size(); ++t) {
      const MovingTriangle moving = surface.triangle(t);
      Box box;
      for (const Corners& c : {moving.t0, moving.t1}) box.include(c.a), box.include(c.b), box.include(c.c);
      const Vec3d gap = max(way.low - box.high, box.low - way.high);
      if (std::max({gap.x, gap.y, gap.z}) <= reach) triangles.push_back(t);
    }
  }

  /// The first crossing from the front of any triangle.
  exact::Answer crossing(const Path& path) const {
    exact::Answer first;
    for (const std::size_t t : triangles) {
      const exact::Answer one = exact::front_crossing(path, surface.triangle(t));
      first.margin = std::min(first.margin, one.margin);
      if (one.crosses && (!first.crosses || one.time < first.time)) first.crosses = true, first.time = one.time;
    }
    return first;
  }

  /// Whether a moving point comes within `limit` [m] of the moving surface, by halving spans of time in which it may.
  bool comes_within(const Path& path, double limit) const {
    const auto near = [&](std::size_t t) {
      const MovingTriangle moving = surface.triangle(t);
      const Corners &s = moving.t0, &e = moving.t1;
      const Vec3d way = path.end - path.start;
      const double speed = std::max({norm(way - (e.a - s.a)), norm(way - (e.b - s.b)), norm(way - (e.c - s.c))});
      std::vector<std::pair<double, double>> spans{{0, 1}};
      while (!spans.empty()) {
        const auto [begin, end] = spans.back();
        spans.pop_back();
        const double middle = 0.5 * (begin + end);
        const Corners c = moving.at(middle);
        const double distance = Soup::distance(path.at(middle), {c.a, c.b, c.c});
        if (distance <= limit) return true;
        if (distance - 0.5 * (end - begin) * speed > limit || end - begin < 1e-9) continue;
        spans.push_back({middle, end}), spans.push_back({begin, middle});
      }
      return false;
    };
    return std::any_of(triangles.begin(), triangles.end(), near);
  }
};

/// A random path that starts in front of a random triangle at t0, up to `reach` away, and moves up to `step` relative to it.
inline Path path_near(const DeformingSurface& surface, double reach, double step, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const MovingTriangle moving = surface.triangle(random() % surface.at_t1().triangles().size());
  const double v = unit(random), w = unit(random) * (1 - v);
  const auto place = [&](const Corners& c) { return (1 - v - w) * c.a + v * c.b + w * c.c; };
  const Vec3d start = place(moving.t0) + reach * unit(random) * fixtures::random_direction(random);
  return {start, start + place(moving.t1) - place(moving.t0) + step * unit(random) * fixtures::random_direction(random)};
}

inline std::vector<DeformingContact> detect(Deforming& detector, const TestPoints& points) {
  std::vector<DeformingContact> contacts;
  detector.detect(points, contacts);
  return contacts;
}

}  // namespace deforming
