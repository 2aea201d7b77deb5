#include "fccda/contact_bounds/cylinder_sectors.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "fccda/contact_bounds/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using std::numbers::pi;

namespace {

/// Contains the neighbourhood of the unit cube: the queries of these tests do not involve a surface.
CylinderSectors contact_bounds_of(const CylinderSectors::Shape& shape) { return CylinderSectors(shape, Surface(fixtures::unit_cube()), Beyond::clip); }

/// A hub of 1 and two sectors of 60° about x and -x, within a radius of 4.
CylinderSectors two_blades(const Vec3d& axis = {0, 0, 1}) {
  return contact_bounds_of({.axis = axis, .radius = 4, .length = 2, .hub_radius = 1, .blades = 2, .sector_angle = pi / 3, .start_angle = -pi / 6});
}

std::string complaint(const CylinderSectors::Shape& shape, const Surface& surface, Beyond beyond = Beyond::error) {
  try {
    CylinderSectors(shape, surface, beyond);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Vec3d about_z(double r, double degrees, double z) { return {r * std::cos(degrees * pi / 180), r * std::sin(degrees * pi / 180), z}; }

constexpr double slack = 4e-3;  // a thousandth of the radius of two_blades

}  // namespace

TEST_CASE("cylinder sectors: the hub and the sectors between the ends are inside") {
  const CylinderSectors fan = two_blades();
  for (const double degrees : {0.0, 29.9, -29.9, 180.0, 150.1, 209.9}) CHECK(fan.contains(about_z(3.9, degrees, 0.9)));
  for (const double degrees : {31.0, 90.0, 149.0, 211.0, 270.0, 329.0}) CHECK_FALSE(fan.contains(about_z(3.9, degrees, 0)));
  for (const double degrees : {0.0, 90.0, 250.0}) {
    CHECK(fan.contains(about_z(0.99, degrees, -1)));
    CHECK_FALSE(fan.contains(about_z(0.99, degrees, 1.01)));
    CHECK_FALSE(fan.contains(about_z(4.01, degrees, 0)));
  }
}

TEST_CASE("cylinder sectors: the distance is exact beside a sector, outside the cylinder, beyond its ends and at the tip of the hub") {
  const CylinderSectors fan = two_blades();
  // to within the slack of hub and sectors, of which the bound is always on the safe side
  const auto check = [&](const Vec3d& point, double distance) {
    CHECK(fan.distance_at_least(point) <= distance + 1e-14);
    CHECK(fan.distance_at_least(point) >= distance - slack - 1e-7);
  };
  check(about_z(3, 60, 0), 3 * std::sin(30 * pi / 180));  // 30° beside the sector
  check(about_z(5, 10, 0), 1);
  check(about_z(2, 10, 1.5), 0.5);
  check(about_z(5, 10, 2), std::sqrt(2.0));
  check(about_z(1.2, 90, 0), 0.2);  // nearer to the hub than to a sector
  check(about_z(3, 10, 0.5), 0);
  // behind the tip of a single sector without a hub
  const CylinderSectors sector = contact_bounds_of({.radius = 4, .length = 2, .blades = 1, .sector_angle = pi / 3, .start_angle = 0});
  CHECK(sector.distance_at_least(about_z(3, 200, 0)) >= 3 - slack);
}

TEST_CASE("cylinder sectors: angles about the axis count from x to y, from y to z and from z to x") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3d direction{}, from{}, towards{};
    direction[axis] = 3;  // need not be a unit vector
    from[(axis + 1) % 3] = towards[(axis + 2) % 3] = 1;
    const CylinderSectors fan =
        contact_bounds_of({.axis = direction, .radius = 4, .length = 2, .hub_radius = 0.5, .blades = 1, .sector_angle = pi / 3, .start_angle = 0});
    CHECK(fan.contains(3 * (std::cos(pi / 6) * from + std::sin(pi / 6) * towards)));
    CHECK_FALSE(fan.contains(3 * (std::cos(pi / 6) * from - std::sin(pi / 6) * towards)));
  }
}

TEST_CASE("cylinder sectors: a path between two sectors is rejected, one that goes from gap to gap through a sector or the hub is not") {
  const CylinderSectors fan = two_blades();
  CHECK_FALSE(fan.may_contact({about_z(3, 70, 0), about_z(3, 110, 0)}, 0.5));
  CHECK(fan.may_contact({about_z(3, 70, 0), about_z(3, 110, 0)}, 3 * std::sin(40 * pi / 180)));
  CHECK(fan.may_contact({about_z(3, 90, 0), about_z(3, -90, 0)}, 0));           // through the hub
  CHECK(fan.may_contact({about_z(3, 60, 0), about_z(3, -60, 0)}, 0));           // through a sector
  CHECK_FALSE(fan.may_contact({about_z(3, 10, 1.5), about_z(3, 10, 3)}, 0.4));  // beyond the end
  CHECK_FALSE(fan.may_contact({about_z(5, 0, 0), about_z(5, 10, 0)}, 0.9));     // outside
  CHECK_FALSE(fan.may_contact({{-3, 4.5, 0}, {3, 4.5, 0}}, 0.4));
}

TEST_CASE("cylinder sectors: sectors that cover the circle or half of it, and a hub as wide as the cylinder, leave no gap") {
  const double whole = pi * 16 * 2;
  const CylinderSectors::Shape two{.radius = 4, .length = 2, .hub_radius = 1, .blades = 2, .sector_angle = 0.5};
  CHECK(contact_bounds_of(two).volume() == fixtures::relative(2 * (pi + 0.5 * 2 * 0.5 * 15), 1e-12));
  for (auto [blades, angle, hub] : {std::tuple(3, 2 * pi / 3, 1.0), {1, pi, 1.0}, {2, 3.0, 4.0}, {5, 2.0, 0.0}}) {
    CylinderSectors::Shape shape = two;
    shape.blades = blades, shape.sector_angle = angle, shape.hub_radius = hub;
    const CylinderSectors full = contact_bounds_of(shape);
    CHECK(full.volume() == fixtures::relative(whole, 1e-12));
    for (int degrees = 0; degrees < 360; degrees += 7) CHECK(full.contains(about_z(3.9, degrees, 0)));
  }
}

TEST_CASE("cylinder sectors: a surface that extends beyond is an error with the panel numbers, in the middle of a panel too") {
  const Surface cube(fixtures::unit_cube());
  CylinderSectors::Shape shape{.point = {0.5, 0.5, 0.5}, .radius = 0.75, .length = 1, .hub_radius = 0.75};
  CHECK(complaint(shape, cube) == "");
  shape.length = 0.9;
  CHECK(complaint(shape, cube) ==
        "contact bounds: 6 of 6 panels extend beyond the cylinder's sectors by up to 0.05 m (panels 0, 1, 2, 3, 4, ...), and contact there would be missed; "
        "enlarge "
        "radius, length, hub_radius or sector_angle, or omit them to have them fitted, or pass Beyond::clip if this is intended.");
  CHECK(CylinderSectors(shape, cube, Beyond::clip).clips());
  // Four sectors that contain the corners and the hub: the middles of the upright panels are between them.
  shape = {.point = {0.5, 0.5, 0.5}, .radius = 0.75, .length = 1, .hub_radius = 0.4, .blades = 4, .sector_angle = 1, .start_angle = pi / 4 - 0.5};
  CHECK(complaint(shape, cube).starts_with("contact bounds: 6 of 6 panels"));
  shape.hub_radius = 0.6;
  CHECK(complaint(shape, cube) == "");
  shape.point = {9, 0, 0};
  CHECK(complaint(shape, cube, Beyond::clip) ==
        "contact bounds: no panel of the surface reaches into the cylinder's sectors, so no contact is possible; check their axis, point and sizes.");
}

TEST_CASE("cylinder sectors: bounds in the middle of a large panel are reached although no corner is inside") {
  Panels square;
  square.vertices = {{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
  square.add_quad(0, 1, 2, 3);
  const Surface wall(square, {.orientation = Orientation::normals});
  const CylinderSectors::Shape small{.point = {13, 17, 0}, .radius = 1, .length = 1, .hub_radius = 0.2, .blades = 3, .sector_angle = 0.4};
  CHECK(CylinderSectors(small, wall, Beyond::clip).clips());
  CHECK(complaint({.point = {13, 17, 2}, .radius = 1, .length = 1, .hub_radius = 1}, wall, Beyond::clip).starts_with("contact bounds: no panel"));
}

TEST_CASE("cylinder sectors: a piece shorter than the slack may cut the corner between hub and sector, and contact counts there") {
  // From the hub, just below the sector that begins at the angle 0, to the sector just outside the hub.
  Panels piece;
  piece.vertices = {{0.9995, -0.0017, 0}, {1.0015, 0, 0}, {0.9995, -0.0017, 0.001}};
  piece.add_triangle(0, 1, 2);
  const Surface surface(piece, {.orientation = Orientation::normals});
  const CylinderSectors fan({.radius = 4, .length = 2, .hub_radius = 1, .blades = 3, .sector_angle = 1, .start_angle = 0}, surface, Beyond::error);
  const Vec3d middle = 0.5 * (piece.vertices[0] + piece.vertices[1]);
  REQUIRE(std::hypot(middle.x, middle.y) > 1.0004);  // outside the hub, and below the sector
  CHECK_FALSE(fan.clips());
  CHECK(fan.contains(middle));
  CHECK(fan.distance_at_least(middle) == 0);
  CHECK(fan.may_contact({middle, middle}, 0));
}

TEST_CASE("cylinder sectors: numbers that are not finite or out of range are refused in a sentence, whether or not the surface may exceed the bounds") {
  const Surface cube(fixtures::unit_cube());
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const CylinderSectors::Shape sound{.radius = 4, .length = 3, .hub_radius = 0.1, .blades = 3, .sector_angle = 1, .start_angle = 0.2};
  for (const Beyond beyond : {Beyond::clip, Beyond::error}) {
    const auto of = [&](auto member, auto value) {
      CylinderSectors::Shape shape = sound;
      shape.*member = value;
      return complaint(shape, cube, beyond);
    };
    using Shape = CylinderSectors::Shape;
    CHECK(of(&Shape::axis, Vec3d{}) ==
          "contact bounds: the axis of the cylinder's sectors is (0, 0, 0), but it must have a direction and a finite length; correct it.");
    for (const Vec3d& axis : {Vec3d{nan, 0, 1}, Vec3d{infinite, 0, 0}, Vec3d{1e200, 0, 0}, Vec3d{1e-200, 0, 0}})
      CHECK(of(&Shape::axis, axis).ends_with("), but it must have a direction and a finite length; correct it."));
    CHECK(of(&Shape::point, Vec3d{0, nan, 0}) == "contact bounds: the centre of the cylinder's sectors is (0, nan, 0) m, but it must be finite; correct it.");
    CHECK(of(&Shape::radius, nan) == "contact bounds: the radius of the cylinder's sectors is nan m, but it must be finite and positive; correct it.");
    CHECK(of(&Shape::length, -1.0) == "contact bounds: the length of the cylinder's sectors is -1 m, but it must be finite and not negative; correct it.");
    CHECK(of(&Shape::hub_radius, nan) ==
          "contact bounds: the radius of the hub of the cylinder's sectors is nan m, but it must be finite and not negative; correct it.");
    CHECK(of(&Shape::sector_angle, 7.0) == "contact bounds: the angle of the cylinder's sectors is 7 rad, but it must be from 0 to 2 pi; correct it.");
    CHECK(of(&Shape::start_angle, nan) == "contact bounds: the begin of the cylinder's sectors is nan rad, but it must be finite; correct it.");
    CHECK(of(&Shape::blades, 0) == "contact bounds: the number of the cylinder's sectors is 0, but it must be from 1 to 1000; correct it.");
    for (const double wrong : {0.0, -2.0, infinite}) CHECK(of(&Shape::radius, wrong).starts_with("contact bounds: the radius of the cyl"));
    for (const double wrong : {nan, infinite}) CHECK(of(&Shape::length, wrong).starts_with("contact bounds: the length of"));
    for (const double wrong : {-0.1, infinite}) CHECK(of(&Shape::hub_radius, wrong).starts_with("contact bounds: the radius of the hub"));
    for (const double wrong : {nan, -1.0, infinite}) CHECK(of(&Shape::sector_angle, wrong).starts_with("contact bounds: the angle of"));
    for (const int wrong : {-3, 1001, 2000000000}) CHECK(of(&Shape::blades, wrong).starts_with("contact bounds: the number of"));
  }
  // the ends of the ranges
  CylinderSectors::Shape whole = sound;
  whole.sector_angle = 2 * pi, whole.hub_radius = 0, whole.blades = 1000;
  CHECK(complaint(whole, cube, Beyond::clip).empty());
}
