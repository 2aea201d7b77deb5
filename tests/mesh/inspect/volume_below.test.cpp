#include "mesh/inspect/volume_below.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;

TEST_CASE("volume below: correct for a box at any height, whether panels are cut by the waterline or end there") {
  const Surface box(make_box({.size = {3, 2, 1}, .edge_length = 0.25}));
  for (const double height : {-2.0, -0.5, -0.25, -0.1, 0.0, 0.33, 0.5, 7.0}) {
    const double depth = std::fmin(1, std::fmax(0, height + 0.5));
    CHECK(volume_below(box, height) == fixtures::absolute(6 * depth, 1e-12 * 6, "m3"));  // of the whole: sums of a few hundred terms
  }
}

TEST_CASE("volume below: the formula of the cap for a sphere at an oblique attitude") {
  const double radius = 1, panel = 0.05;
  const Panels ball = fixtures::moved(make_sphere({.diameter = 2 * radius, .edge_length = panel}), [](const Vec3d& p) { return p + Vec3d{0, 0, 5}; });
  const Surface surface(ball);
  for (const double height : {4.3, 5.0, 5.6}) {
    const double h = height - 4;
    // chords of length panel lie panel²/8 inside the sphere, over the wetted area
    CHECK(volume_below(surface, height) == fixtures::relative(std::numbers::pi * h * h * (3 * radius - h) / 3, 2e-3));
  }
  CHECK(volume_below(surface, 100) == fixtures::relative(surface.report().volume, 1e-12));  // all of it; another sum
}

TEST_CASE("volume below: correct for a tetrahedron with each face cut in two, upright and on its tip") {
  const Surface upright(fixtures::tetrahedron());
  const Surface on_tip(fixtures::moved(fixtures::tetrahedron(), [](const Vec3d& p) { return Vec3d{p.y, p.x, 1 - p.z}; }));
  for (const double height : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    CHECK(volume_below(upright, height) == fixtures::absolute((1 - std::pow(1 - height, 3)) / 6, 1e-15, "m3"));  // a few roundings of the whole
    CHECK(volume_below(on_tip, height) == fixtures::absolute(std::pow(height, 3) / 6, 1e-15, "m3"));
  }
}
