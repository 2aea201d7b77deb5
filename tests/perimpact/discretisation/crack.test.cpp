// Cracks: bonds that go through a polygon, against a loop over its triangles; and what is decided on edges and in the plane.
#include "perimpact/discretisation/crack.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

#include "base/error.hpp"
#include "perimpact/discretisation/frame.hpp"

using namespace perimpact;

namespace {

constexpr double tolerance = 1e-9;

/// An L, which is not convex.
const std::vector<Vec3d> corner{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

/// Does the segment go through the L? It is two boxes; by their own formulas.
bool goes_through(const Vec3d& a, const Vec3d& b) {
  if ((a.z > 0) == (b.z > 0)) return false;
  const Vec3d p = a + a.z / (a.z - b.z) * (b - a);
  return (p.x > 0 && p.x < 2 && p.y > 0 && p.y < 1) || (p.x > 0 && p.x < 1 && p.y > 0 && p.y < 2);
}

std::vector<Vec3d> turned(std::vector<Vec3d> points, const Frame& frame) {
  for (Vec3d& point : points) point = frame.to_world(point);
  return points;
}

std::string complaint(const std::vector<Vec3d>& polygon) {
  try {
    Crack(polygon, tolerance);
  } catch (const fccda::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("crack: exactly the segments through the polygon are cut, in any orientation and order of ends") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-1, 3), height(-1, 1);
  for (const Frame& frame : {Frame{}, frame_of({0.3, 0.2, -5}, {0.4, -2.1, 1.3})}) {
    const Crack crack(turned(corner, frame), tolerance);
    int cut = 0;
    for (int n = 0; n < 20000; ++n) {
      const Vec3d a{place(random), place(random), height(random)}, b{place(random), place(random), height(random)};
      const bool is_cut = crack.cuts(frame.to_world(a), frame.to_world(b));
      CHECK(is_cut == goes_through(a, b));
      CHECK(crack.cuts(frame.to_world(b), frame.to_world(a)) == is_cut);
      cut += is_cut ? 1 : 0;
    }
    CHECK(cut > 1000);
  }
}

TEST_CASE("crack: a bond through an edge or corner is cut, one that passes outside is not") {
  const Crack crack(corner, tolerance);
  const auto cuts_at = [&](double x, double y) { return crack.cuts({x, y, 0.5}, {x, y, -0.5}); };
  CHECK(cuts_at(2, 0.5));
  CHECK(cuts_at(1, 1));
  CHECK(cuts_at(0, 0));
  CHECK(cuts_at(2 + tolerance / 2, 0.5));
  CHECK(!cuts_at(2 + 3 * tolerance, 0.5));
  CHECK(!cuts_at(1.5, 1.5));
}

TEST_CASE("crack: a particle in its plane counts as on the side of the normal, so that its layer stays intact and separates from the one below") {
  const Crack crack(corner, tolerance);  // anticlockwise seen from above: the normal points up
  const auto x = [](double z) { return Vec3d{0.5, 0.5, z}; };
  CHECK(crack.cuts(x(0), x(-1)));
  CHECK(!crack.cuts(x(0), x(1)));
  CHECK(!crack.cuts(x(0), {1.5, 0.5, 0}));
  CHECK(crack.cuts(x(-tolerance / 2), x(-1)));  // rounding below the plane
  CHECK(!crack.cuts(x(-tolerance / 2), x(1)));
  CHECK(crack.contains(x(0)));
  CHECK(!crack.contains(x(3 * tolerance)));
  CHECK(!crack.contains({1.5, 1.5, 0}));
  const Crack other_way({corner.rbegin(), corner.rend()}, tolerance);
  CHECK(!other_way.cuts(x(0), x(-1)));
  CHECK(other_way.cuts(x(0), x(1)));
}

TEST_CASE("crack: in a plane body a line of two points cuts what crosses it within the plane") {
  const Crack crack = Crack::through_thickness({0, 0, 0.2}, {1, 1, 0.2}, tolerance);
  CHECK(crack.cuts({0.4, 0.6, 0.2}, {0.6, 0.4, 0.2}));
  CHECK(!crack.cuts({1.4, 1.6, 0.2}, {1.6, 1.4, 0.2}));
  CHECK(!crack.cuts({0.4, 0.6, 0.2}, {0.2, 0.9, 0.2}));
  CHECK_THROWS_WITH_AS(Crack::through_thickness({1, 1, 0}, {1, 1, 0}, tolerance), "both ends of the crack coincide; move one of them.", fccda::InputError);
}

TEST_CASE("crack: invalid polygons are refused in one sentence") {
  CHECK(complaint({{0, 0, 0}, {1, 0, 0}}) ==
        "the crack has 2 corners, but a polygon needs at least three (a line of two is for plane bodies only); give them in order around it.");
  CHECK(complaint({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}) == "the crack's corners are collinear, so it has no area; move one of them.");
  CHECK(complaint({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}) ==
        "corner 1 of the crack lies 0.118 m off the plane of the others, but a crack is plane; move it, or use two cracks.");
  CHECK(complaint({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}) ==
        "the side after corner 1 of the crack intersects the one after corner 3; give the corners in order around it.");
  CHECK(complaint({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == "corners 2 and 3 of the crack coincide; remove one.");
}
