/// Scenes for detectors: bodies, points on straight paths, and reference solutions that share nothing with the library but Vec3.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "fccda/detect/contact.hpp"
#include "fccda/detect/swept.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"

namespace fixtures {

using fccda::Contact;
using fccda::Motion;
using fccda::Path;
using fccda::Pose;
using fccda::Quaternion;
using fccda::Surface;

/// Points in blocks of equal size; all exist.
struct TestPoints {
  std::vector<Vec3d> x0, x1;
  std::vector<Vec3d> v;
  std::vector<double> m;
  std::size_t block = 64;

  std::size_t size() const { return x0.size(); }
  Vec3d position_t0(std::size_t i) const { return x0[i]; }
  Vec3d position_t1(std::size_t i) const { return x1[i]; }
  bool occupied(std::size_t) const { return true; }
  std::size_t block_count() const { return (size() + block - 1) / block; }
  std::size_t block_begin(std::size_t b) const { return b * block; }
  std::size_t block_end(std::size_t b) const { return std::min(size(), (b + 1) * block); }
  double block_travel(std::size_t b) const {
    double most = 0;
    for (std::size_t i = block_begin(b); i < block_end(b); ++i) most = fixtures::larger(most, norm(x1[i] - x0[i]));
    return most;
  }
  double mass(std::size_t i) const { return m[i]; }
  Vec3d velocity(std::size_t i) const { return v[i]; }
  void set(std::size_t i, const Vec3d& position, const Vec3d& velocity) { x1[i] = position, v[i] = velocity; }
};

inline Motion at_rest(const Pose& pose = {}) { return {pose, pose, 1}; }

template <class Detector>
std::vector<Contact> detect(Detector& detector, const TestPoints& points, const Motion& motion = at_rest(), double surface_travel = 0) {
  std::vector<Contact> contacts;
  detector.detect(points, motion, surface_travel, contacts);
  return contacts;
}

inline TestPoints points_on(const std::vector<Path>& paths, const Motion& motion = at_rest()) {
  TestPoints points;
  for (const Path& path : paths) {
    points.x0.push_back(motion.t0.to_world(path.start));
    points.x1.push_back(motion.t1.to_world(path.end));
  }
  return points;
}

/// The 24 rotations that map a cube onto itself, every second one followed by a small odd one, so that panels are axis-aligned and
/// oblique.
inline std::vector<Pose> orientations() {
  std::vector<Pose> poses;
  const double quarter = std::numbers::pi / 2;
  const Vec3d faces[6] = {{}, {quarter, 0, 0}, {2 * quarter, 0, 0}, {3 * quarter, 0, 0}, {0, quarter, 0}, {0, 3 * quarter, 0}};
  for (int k = 0; k < 24; ++k) {
    Quaternion turn = Quaternion::from_rotation({0, 0, (k % 4) * quarter}) * Quaternion::from_rotation(faces[k / 4]);
    if (k % 2 == 1) turn = Quaternion::from_rotation({0.1 * k, -0.07, 0.31}) * turn;
    poses.push_back(Pose({0.3 * k, -1, 2}, turn.normalised()));
  }
  return poses;
}

// ---- bodies, all about a unit in size ----

struct Body {
  const char* name;
  Panels panels;
};

inline Panels cylinder() {
  return fccda::make_cylinder({.diameter = 1, .height = 0.5, .axis = fccda::Axis::z, .edge_length = 0.1, .panels = fccda::PanelKind::quads});
}
inline Panels sphere() { return fccda::make_sphere({.diameter = 1, .edge_length = 0.12}); }
inline Panels box() { return fccda::make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.2, .panels = fccda::PanelKind::quads}); }

/// A blade: an ellipsoid of 1 × 0.4 × 0.016, thinner towards its edges.
inline Panels blade() {
  return moved(sphere(), [](const Vec3d& p) { return Vec3d{p.x, 0.4 * p.y, 0.016 * p.z}; });
}

/// Similar to a hull: longer than wide, with hollows and bumps.
inline Panels hull() {
  return moved(sphere(), [](const Vec3d& p) {
    const double bump = 1 + 0.15 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
    return Vec3d{bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
  });
}

inline std::vector<Body> bodies() {
  return {{"cylinder", cylinder()}, {"sphere", sphere()}, {"box", box()}, {"torus", torus(0.4, 0.15, 24, 12, 1)}, {"blade", blade()}, {"hull", hull()}};
}

inline std::shared_ptr<const Surface> surface_of(const Panels& panels) { return std::make_shared<const Surface>(panels); }

// ---- reference solutions ----

/// The triangles of a surface by their corners alone.
struct Soup {
  std::vector<std::array<Vec3d, 3>> triangles;

  explicit Soup(const Surface& surface) {
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) triangles.push_back({surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)});
  }

  /// Distance of a point from a triangle: the plane's where the three barycentric coordinates are positive, else the least of the
  /// edges', each found by halving the interval of a convex function.
  static double distance(const Vec3d& p, const std::array<Vec3d, 3>& t) {
    const Vec3d e = t[1] - t[0], f = t[2] - t[0], g = p - t[0];
    const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), ge = dot(g, e), gf = dot(g, f), det = ee * ff - ef * ef;
    const double v = (ff * ge - ef * gf) / det, w = (ee * gf - ef * ge) / det;
    if (v > 0 && w > 0 && v + w < 1) return norm(g - v * e - w * f);
    double least = 1e300;
    for (int k = 0; k < 3; ++k) {
      const Vec3d a = t[static_cast<std::size_t>(k)], d = t[static_cast<std::size_t>((k + 1) % 3)] - a;
      const double s = std::min(1.0, std::max(0.0, dot(p - a, d) / dot(d, d)));
      least = std::min(least, norm(p - a - s * d));
    }
    return least;
  }

  double distance(const Vec3d& p) const {
    double least = 1e300;
    for (const auto& t : triangles) least = std::min(least, distance(p, t));
    return least;
  }

  bool inside(const Vec3d& point) const {
    WindingNumber winding(point);
    for (const auto& t : triangles) winding(t[0], t[1], t[2]);
    return winding.value() > 0.5;
  }

  /// Distance of a segment from the surface: to each triangle it is a convex function along the segment, so its least value is found by
  /// shrinking the interval to the golden section. Good to about 1e-9 of the segment's length.
  double distance(const Path& path) const {
    double least = 1e300;
    for (const auto& t : triangles) {
      if (distance(path.at(0.5), t) - 0.5 * path.length() > least) continue;
      const double section = (std::sqrt(5.0) - 1) / 2;
      double low = 0, high = 1;
      for (int k = 0; k < 50; ++k) {
        const double a = high - section * (high - low), b = low + section * (high - low);
        if (distance(path.at(a), t) < distance(path.at(b), t))
          high = b;
        else
          low = a;
      }
      least = std::min(least, distance(path.at(0.5 * (low + high)), t));
    }
    return least;
  }
};

/// Paths about as long as `step` that begin outside near the surface, farther than r from it, and whether each comes nearer than r (for
/// r = 0: crosses). Undecided ones, within 1e-6 of r, are excluded.
struct Shots {
  std::vector<Path> paths;
  std::vector<bool> touches;

  Shots(const Soup& soup, double r, double step, std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    while (paths.size() < count) {
      const auto& t = soup.triangles[random() % soup.triangles.size()];
      const double u = unit(random), v = unit(random) * (1 - u);
      const Vec3d place = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      Path path;
      path.start = place + (r + step * unit(random)) * random_direction(random);
      path.end = path.start + step * random_direction(random);
      if (!(soup.distance(path.start) > r + 1e-6) || soup.inside(path.start)) continue;
      const double distance = soup.distance(path);
      const bool meets = r > 0 ? distance < r - 1e-6 : distance < 1e-9;
      if (!meets && distance < r + 1e-6) continue;
      paths.push_back(path);
      touches.push_back(meets);
    }
  }
};

}  // namespace fixtures
