/// The shapes of the detection tests: about a unit in size, a few thousand panels each.
#pragma once

#include <cmath>
#include <vector>

#include "fccda/detect/scene.hpp"

namespace evidence {

using namespace fccda;

inline Panels cylinder(Axis axis) { return make_cylinder({.diameter = 1, .height = 0.5, .axis = axis, .edge_length = 0.05, .panels = PanelKind::quads}); }

/// Its axis is none of the coordinate axes, its panels are parallel to none of their planes.
inline Panels oblique_cylinder() {
  const Pose askew({}, Quaternion::from_rotation({0.7, 0.5, 0.3}));
  return fixtures::moved(cylinder(Axis::z), [&](const Vec3d& p) { return askew.to_world(p); });
}

inline Panels sphere() { return make_sphere({.diameter = 1, .edge_length = 0.06}); }

/// An ellipsoid of 1 × 0.4 × 0.016, thinner towards its edge: 4 % of its chord.
inline Panels blade() {
  return fixtures::moved(sphere(), [](const Vec3d& p) { return Vec3d{p.x, 0.4 * p.y, 0.016 * p.z}; });
}

/// Similar to a hull: longer than wide, with hollows and bumps.
inline Panels hull() {
  return fixtures::moved(sphere(), [](const Vec3d& p) {
    const double bump = 1 + 0.15 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
    return Vec3d{bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
  });
}

/// `name`: its name in tables.
inline std::vector<fixtures::Body> shapes() {
  return {{"cylinder along x", cylinder(Axis::x)},
          {"cylinder along y", cylinder(Axis::y)},
          {"cylinder along z", cylinder(Axis::z)},
          {"oblique cylinder", oblique_cylinder()},
          {"sphere", sphere()},
          {"torus", fixtures::torus(0.4, 0.15, 60, 30)},
          {"torus of warped quads", fixtures::torus(0.4, 0.15, 60, 30, 1)},
          {"box", make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.04, .panels = PanelKind::quads})},
          {"blade", blade()},
          {"hull", hull()}};
}

}  // namespace evidence
