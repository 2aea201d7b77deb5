#include "mesh/submerged.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/parallel.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "marine/hull.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;

namespace {

Surface ship() {
  constexpr double degree = std::numbers::pi / 180;
  return Surface(
      make_hull({.length = 30, .breadth = 5, .draft = 2, .freeboard = 1, .stem_angle = 30 * degree, .waterline_angle = 25 * degree, .edge_length = 0.5}));
}

}  // namespace

TEST_CASE("submerged: the first moments of a heeled box are those of the wall-sided formula") {
  const double length = 3, breadth = 2, depth = 1.5;
  const Surface box(make_box({.size = {length, breadth, depth}, .edge_length = 0.3}));
  for (const double tangent : {0.0, 0.1, -0.4}) {
    for (const double draft : {0.6, 0.75, 0.9}) {  // the waterline stays on the sides
      const double cosine = 1 / std::sqrt(1 + tangent * tangent);
      // water up to z = draft - depth/2 + y tan φ
      const Level level{.up = {0, -tangent * cosine, cosine}, .height = (draft - 0.5 * depth) * cosine};
      const SubmergedVolume wet = submerged(box, level);
      // ∫ y dV = L ∫ y (T + y t) dy = L B³ t/12, and ∫ z dV likewise; a few hundred roundings
      CHECK(wet.volume == fixtures::relative(length * breadth * draft, 1e-13));
      CHECK(std::fabs(wet.centre.x) < 1e-13);
      CHECK(wet.centre.y == fixtures::absolute(breadth * breadth * tangent / (12 * draft), 1e-12, "m"));
      const double squares = draft * draft + breadth * breadth * tangent * tangent / 12;  // mean of (T + y t)²
      CHECK(wet.centre.z == fixtures::relative(-0.5 * depth + 0.5 * squares / draft, 1e-12));
      CHECK(wet.waterplane == fixtures::relative(length * breadth / cosine, 1e-13));
    }
  }
}

TEST_CASE("submerged: volume, centre and waterplane of a sphere converge to the cap's with the square of the panel size") {
  const double radius = 1;
  std::mt19937_64 random(7);
  const Vec3d up = fixtures::random_direction(random);
  for (const double depth : {0.4, 1.0, 1.7}) {  // of the lowest point
    double last = 0;
    for (const double panel : {0.1, 0.05}) {
      const SubmergedVolume wet = submerged(Surface(make_sphere({.diameter = 2 * radius, .edge_length = panel})), {.up = up, .height = depth - radius});
      const double volume = std::numbers::pi * depth * depth * (3 * radius - depth) / 3;
      const double below = 0.75 * (2 * radius - depth) * (2 * radius - depth) / (3 * radius - depth);  // of the centroid under the centre
      // chords of the length of a panel lie up to panel²/8 inside the sphere
      CHECK(wet.volume == fixtures::relative(volume, panel * panel));
      CHECK(norm(wet.centre + below * up) < 0.2 * panel * panel);
      CHECK(wet.waterplane == fixtures::relative(std::numbers::pi * depth * (2 * radius - depth), panel * panel));
      const double missing = volume - wet.volume;
      if (last > 0) CHECK(last / missing == fixtures::relative(4, 0.15));
      last = missing;
    }
  }
}

TEST_CASE("submerged: the share of the height for an upright cylinder, the segment of the circle for a horizontal one") {
  const Surface cylinder(make_cylinder({.diameter = 2, .height = 3, .axis = Axis::z, .edge_length = 0.05}));
  for (const double depth : {0.3, 1.1, 2.9}) {
    const SubmergedVolume wet = submerged(cylinder, {.height = depth - 1.5});
    CHECK(wet.volume == fixtures::relative(cylinder.report().volume * depth / 3, 1e-12));  // a prism
    CHECK(norm(wet.centre - Vec3d{0, 0, 0.5 * depth - 1.5}) < 1e-12);
  }
  for (const double depth : {0.3, 1.0, 1.6}) {
    const SubmergedVolume wet = submerged(cylinder, {.up = {1, 0, 0}, .height = depth - 1});
    const double angle = std::acos(1 - depth), area = angle - std::sin(angle) * std::cos(angle);  // radius 1
    // 126 chords around lie panel²/8 inside at most, over an arc of 2 angle
    CHECK(wet.volume == fixtures::absolute(3 * area, 0.05 * 0.05 / 8 * 2 * angle * 3, "m3"));
    CHECK(wet.centre.x == fixtures::relative(-2 * std::pow(std::sin(angle), 3) / (3 * area), 1e-3));
  }
}

TEST_CASE("submerged: the volumes on the two sides of any plane add up to the whole, with the same waterplane") {
  std::mt19937_64 random(11);
  for (const Surface& surface : {ship(), Surface(make_sphere({.diameter = 2, .edge_length = 0.2})), Surface(fixtures::tetrahedron())}) {
    const SurfaceReport& whole = surface.report();
    const double size = norm(whole.bounds.high - whole.bounds.low);
    std::uniform_real_distribution<double> offset(-0.4 * size, 0.4 * size);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3d up = fixtures::random_direction(random);
      const double height = dot(up, whole.bounds.centre()) + offset(random);
      const SubmergedVolume below = submerged(surface, {up, height}), above = submerged(surface, {-up, -height});
      // a thousand triangles and roundings of the size
      REQUIRE(std::fabs(below.volume + above.volume - whole.volume) < 1e-12 * whole.volume);
      REQUIRE(norm(below.volume * below.centre + above.volume * above.centre - whole.volume * whole.centroid) < 1e-12 * whole.volume * size);
      REQUIRE(std::fabs(below.waterplane - above.waterplane) < 1e-12 * size * size);
    }
  }
}

TEST_CASE("submerged: the waterplane is the derivative of the volume, and the waterplane's moment that of the first moment") {
  const Surface surface = ship();
  std::mt19937_64 random(3);
  const double rise = 1e-4;
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3d up = fixtures::random_direction(random);
    const double height = dot(up, surface.report().centroid);
    const SubmergedVolume low = submerged(surface, {up, height - rise}), at = submerged(surface, {up, height}), high = submerged(surface, {up, height + rise});
    // central differences: the curvature of the waterplane is some A/(1 m)² times rise²/6, and its kinks at vertices are A/(1 m) times rise
    CHECK((high.volume - low.volume) / (2 * rise) == fixtures::relative(at.waterplane, 1e-4));
    const double moment = (high.volume * (dot(up, high.centre) - height) - low.volume * (dot(up, low.centre) - height)) / (2 * rise);
    CHECK(std::fabs(moment) < 1e-4 * at.waterplane);  // the plane is at height 0
  }
}

TEST_CASE("submerged: nothing above the plane, the report's volume below it, and the same for any number of threads") {
  const Surface ball(make_sphere({.diameter = 2, .edge_length = 0.05}));
  CHECK(submerged(ball, {.height = -1.01}).volume == 0);
  CHECK(submerged(ball, {.height = 1.01}).volume == ball.report().volume);
  CHECK(submerged(ball, {.height = 1.01}).centre == ball.report().centroid);
  const fixtures::Threads with_one(1);
  const SubmergedVolume one = submerged(ball, {.height = 0.123});
  for (const int count : {2, 3, 5}) {
    const fixtures::Threads with_several(count);
    const SubmergedVolume same = submerged(ball, {.height = 0.123});
    CHECK((same.volume == one.volume && same.centre == one.centre && same.waterplane == one.waterplane));
  }
}
