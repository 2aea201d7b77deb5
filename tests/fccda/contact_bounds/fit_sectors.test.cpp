#include "fccda/contact_bounds/fit_sectors.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "fccda/contact_bounds/angular_occupancy.hpp"
#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using std::numbers::pi;

namespace {

/// By the check applied to specified sectors, and by points of the surface.
void check_holds(const CylinderSectors::Shape& shape, const Surface& surface) {
  const CylinderSectors region(shape, surface, Beyond::error);
  CHECK_FALSE(region.clips());
  std::mt19937_64 random(11);
  for (int k = 0; k < 500; ++k) CHECK(region.contains(fixtures::random_place(random, surface)));
}

}  // namespace

TEST_CASE("fit sectors: a propeller's axis, blades, radius and length are found, whatever its orientation") {
  for (const int blades : {3, 4, 5, 7}) {
    CAPTURE(blades);
    const fixtures::PropellerShape sizes{.blades = blades, .chord = 0.2, .edge_length = 0.05};
    const Surface straight(fixtures::propeller(sizes)), turned(fixtures::askew(fixtures::propeller(sizes)));
    const CylinderSectors::Shape a = fit_sectors(straight, {}), b = fit_sectors(turned, {});
    check_holds(a, straight);
    check_holds(b, turned);
    CHECK(a.blades == blades);
    // The blade meshes are symmetric only as far as an icosahedron is: the principal axis is off by some 1e-4.
    CHECK(a.axis.z == fixtures::relative(1, 1e-4));
    CHECK(a.radius == fixtures::relative(sizes.radius, 1e-9));
    // the same body in another frame: the fit is the same but for rounding and the hub's steps
    CHECK(b.blades == blades);
    CHECK(CylinderSectors::volume_of(b) == fixtures::relative(CylinderSectors::volume_of(a), 0.01));
  }
}

TEST_CASE("fit sectors: the fan is as narrow as the blades are") {
  // Plates of known width: two edges at ±0.1 rad at a radius of 1, a hub of 0.2.
  Panels plates = make_cylinder({.diameter = 0.4, .height = 0.5, .axis = Axis::z, .edge_length = 0.05});
  for (int blade = 0; blade < 3; ++blade) {
    const double at = 2 * pi * blade / 3 + 0.3;
    plates = fixtures::joined(plates, fixtures::moved(fixtures::unit_cube(), [&](const Vec3d& p) {
                                const double r = 0.1 + 0.9 * p.x, angle = at + 0.2 * (p.y - 0.5);
                                return Vec3d{r * std::cos(angle), r * std::sin(angle), 0.4 * (p.z - 0.5)};
                              }));
  }
  const Surface surface(plates);
  const CylinderSectors::Shape shape = fit_sectors(surface, {});
  check_holds(shape, surface);
  CHECK(shape.blades == 3);
  CHECK(shape.sector_angle == fixtures::relative(0.2, 1e-9));
  CHECK(std::fabs(std::remainder(shape.start_angle + 0.1 - 0.3, 2 * pi / 3)) < 1e-9);
  // the hub steps of a 64th of the radius, and its edges between the columns
  CHECK(shape.hub_radius >= 0.2);
  CHECK(shape.hub_radius <= 0.2 + 1.0 / 64);
  CHECK(shape.length == fixtures::relative(0.5, 1e-12));
}

TEST_CASE("fit sectors: skewed blades widen the sectors, and blades that overlap in angle leave no gap") {
  const Surface straight(fixtures::propeller({.chord = 0.2})), skewed(fixtures::propeller({.chord = 0.2, .skew = 0.8})),
      overlapping(fixtures::propeller({.blades = 5, .chord = 0.9, .pitch = 0.3}));
  const CylinderSectors::Shape narrow = fit_sectors(straight, {.hub_radius = 0.15, .blades = 4}), wide = fit_sectors(skewed, {.hub_radius = 0.15, .blades = 4}),
                               full = fit_sectors(overlapping, {});
  check_holds(wide, skewed);
  check_holds(full, overlapping);
  CHECK(wide.sector_angle > narrow.sector_angle + 0.3);
  CHECK(narrow.has_gaps());
  // Tips are narrow: a gap there may be worth a hundredth, hardly more.
  CHECK(CylinderSectors::volume_of(full) > 0.9 * pi * full.radius * full.radius * full.length);
  CHECK_FALSE(fit_sectors(overlapping, {.hub_radius = 0.2}).has_gaps());
}

TEST_CASE("fit sectors: prescribed parameters are kept, the others are fitted") {
  const Surface surface(fixtures::propeller({.chord = 0.2}));
  const CylinderSectors::Shape shape = fit_sectors(
      surface, {.axis = Vec3d{0, 0, 2}, .point = Vec3d{0, 0, 0.01}, .radius = 0.7, .length = 0.6, .hub_radius = 0.2, .blades = 2, .sector_angle = 2.9});
  CHECK(shape.axis == Vec3d{0, 0, 1});
  CHECK(shape.point == Vec3d{0, 0, 0.01});
  CHECK(shape.radius == 0.7);
  CHECK(shape.length == 0.6);
  CHECK(shape.hub_radius == 0.2);
  CHECK(shape.blades == 2);
  CHECK(shape.sector_angle == 2.9);
  check_holds(shape, surface);  // the sectors are centred on the blades
  const CylinderSectors::Shape from = fit_sectors(surface, {.sector_angle = 0.1, .start_angle = 0.4});
  CHECK(from.start_angle == 0.4);
  // A point off the middle: the length reaches the farther end.
  const CylinderSectors::Shape off = fit_sectors(surface, {.axis = Vec3d{0, 0, 1}, .point = Vec3d{0, 0, 0.1}});
  CHECK(off.length == fixtures::relative(2 * (0.125 + 0.1), 1e-12));
  check_holds(off, surface);
}

TEST_CASE("fit sectors: for a cylinder in any direction the result is the whole cylinder") {
  const Surface surface(fixtures::askew(make_cylinder({.diameter = 1, .height = 3, .axis = Axis::x, .edge_length = 0.1})));
  const CylinderSectors::Shape shape = fit_sectors(surface, {});
  CHECK_FALSE(shape.has_gaps());
  // the mesh is inscribed: its volume is less by 2 % at most
  CHECK(CylinderSectors::volume_of(shape) == fixtures::relative(surface.report().volume, 0.02));
}
