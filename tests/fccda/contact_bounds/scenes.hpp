/// Surfaces, and every kind of contact bounds for each.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "fccda/contact_bounds/fit_boxes.hpp"
#include "fccda/contact_bounds/fit_contact_bounds.hpp"
#include "fccda/contact_bounds/fit_sectors.hpp"
#include "fixtures/propeller.hpp"
#include "fixtures/surfaces.hpp"

namespace fixtures {

using fccda::Beyond;
using fccda::BoxUnion;
using fccda::ContactBounds;
using fccda::CylinderSectors;
using fccda::Surface;

struct ToBound {
  std::string name;
  Surface surface;
};

/// A step: an outline in x and z, one unit deep in y, that two boxes fill exactly. Its volume is 3.
inline Panels step_body() {
  const std::array<std::array<double, 2>, 7> outline{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}};
  Panels step;
  for (const double y : {0.0, 1.0})
    for (const auto& [x, z] : outline) step.vertices.push_back({x, y, z});
  const int n = static_cast<int>(outline.size());
  for (int k = 0; k < n; ++k) step.add_quad(k, n + k, n + (k + 1) % n, (k + 1) % n);
  step.add_quad(0, 1, 5, 6);
  step.add_quad(n, n + 6, n + 5, n + 1);
  for (const auto& [a, b, c] : {std::array{1, 2, 5}, {2, 3, 5}, {3, 4, 5}}) {
    step.add_triangle(a, b, c);
    step.add_triangle(n + a, n + c, n + b);
  }
  return step;
}

inline Panels hull_like() {
  return moved(fccda::make_sphere({.diameter = 1, .edge_length = 0.1}), [](const Vec3d& p) { return Vec3d{4 * p.x, p.y, p.z < 0 ? 1.2 * p.z : 0.3 * p.z}; });
}

/// Rotated, so that nothing is axis-aligned.
inline Panels askew(const Panels& panels) {
  const fccda::Vec3d u = fccda::normalised(fccda::Vec3d{1, 2, 0.5}), v = fccda::normalised(cross(u, fccda::Vec3d{0, 0.3, 1})), w = cross(u, v);
  return moved(panels, [=](const Vec3d& p) { return Vec3d{0.2, -0.1, 0.4} + p.x * u + p.y * v + p.z * w; });
}

inline std::vector<ToBound> surfaces_to_bound() {
  std::vector<ToBound> all;
  all.push_back({"cube", Surface(unit_cube())});
  all.push_back({"step", Surface(step_body())});
  all.push_back({"hull", Surface(hull_like())});
  all.push_back({"propeller", Surface(propeller({.edge_length = 0.06}))});
  all.push_back({"skewed propeller, askew", Surface(askew(propeller({.skew = 0.6, .edge_length = 0.06})))});
  all.push_back({"blades that overlap in angle", Surface(propeller({.blades = 5, .chord = 0.9, .pitch = 0.3, .edge_length = 0.06}))});
  return all;
}

struct NamedRegion {
  std::string name;
  ContactBounds region;
};

/// Each kind of contact bounds, specified and fitted, containing the whole surface and clipping it.
inline std::vector<NamedRegion> every_region(const Surface& surface) {
  const fccda::Box& bounds = surface.report().bounds;
  const fccda::Vec3d size = bounds.size(), centre = bounds.centre();
  const BoxUnion::Shape whole{.size = 1.1 * size, .centre = centre}, thin{.size = {size.x, 0.4 * size.y, size.z}, .centre = centre};
  const BoxUnion::Shape halves[] = {{{0.5 * size.x, size.y, size.z}, centre - fccda::Vec3d{0.25 * size.x, 0, 0}},
                                    {{0.5 * size.x, size.y, size.z}, centre + fccda::Vec3d{0.25 * size.x, 0, 0}}};
  const BoxUnion::Shape apart[] = {{{0.3 * size.x, size.y, size.z}, bounds.low + 0.3 * size}, {{0.3 * size.x, size.y, size.z}, bounds.high - 0.2 * size}};
  const CylinderSectors::Shape narrow{.axis = {0.1, 0.2, 1},
                                      .point = centre,
                                      .radius = 0.4 * size.x,
                                      .length = size.z,
                                      .hub_radius = 0.1 * size.x,
                                      .blades = 3,
                                      .sector_angle = 0.7,
                                      .start_angle = 0.2};
  return {{"unbounded", fccda::Unbounded{}},
          {"one box", BoxUnion(whole, surface, Beyond::error)},
          {"one box that clips", BoxUnion(thin, surface, Beyond::clip)},
          {"two boxes", BoxUnion(halves, surface, Beyond::error)},
          {"two boxes that clip", BoxUnion(apart, surface, Beyond::clip)},
          {"fitted boxes", BoxUnion(fit_boxes(surface, {.most = 12, .gain = 0}))},
          {"sectors that clip", CylinderSectors(narrow, surface, Beyond::clip)},
          {"fitted sectors", CylinderSectors(fit_sectors(surface, {}), surface, Beyond::error)},
          {"auto", fccda::fit_contact_bounds(surface).region}};
}

/// A random point of the surface, more often where panels are small.
inline Vec3d random_place(std::mt19937_64& random, const Surface& surface) {
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t t = random() % surface.triangles().size();
  const double u = unit(random), v = unit(random) * (1 - u);
  return surface.corner(t, 0) + u * (surface.corner(t, 1) - surface.corner(t, 0)) + v * (surface.corner(t, 2) - surface.corner(t, 0));
}

}  // namespace fixtures
