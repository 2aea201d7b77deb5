#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

Panels scaled(const Panels& panels, double factor, const Vec3d& shift = {}) {
  return fixtures::moved(panels, [&](const Vec3d& v) { return factor * v + shift; });
}

/// The surface's triangles as panels, with their final winding.
Panels panels_of(const Surface& surface) {
  Panels out{{surface.vertices().begin(), surface.vertices().end()}, {}};
  for (const Triangle& t : surface.triangles()) out.add_triangle(t.vertex[0], t.vertex[1], t.vertex[2]);
  return out;
}

}  // namespace

TEST_CASE("winding: randomly flipped panels are corrected and counted") {
  std::mt19937_64 random(1);
  for (const Panels& good :
       {make_sphere({.diameter = 1, .edge_length = 0.1}), fixtures::torus(2, 0.5, 30, 15, 1), make_box({.size = {1, 2, 3}, .edge_length = 0.3})}) {
    const Surface expected(good);
    Panels spoilt = good;
    std::size_t turned = 0;
    for (auto& panel : spoilt.panels) {
      if (random() % 3 != 0) continue;
      panel[3] < 0 ? std::swap(panel[1], panel[2]) : std::swap(panel[1], panel[3]);
      turned += panel[3] < 0 ? 1 : 2;
    }
    const Surface mended(spoilt);
    CHECK(mended.report().rewound == turned);
    CHECK(mended.report().flipped == 0);
    CHECK(fixtures::is_watertight(panels_of(mended)));
    CHECK(mended.report().volume == fixtures::relative(expected.report().volume, 1e-3));  // warped quads may be split differently
  }
}

TEST_CASE("winding: the majority of an open surface's panels decides") {
  Panels open = make_sphere({.diameter = 1, .edge_length = 0.1});
  open.panels.resize(open.panels.size() - 7);
  std::swap(open.panels[0][1], open.panels[0][2]);  // the first one is wrong
  const Surface surface(open, {.orientation = Orientation::normals, .name = "bowl"});
  CHECK(surface.report().rewound == 1);
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) CHECK(dot(surface.normal(t), surface.corner(t, 0)) > 0);
}

TEST_CASE("outward: a closed surface given inside out is flipped as a whole") {
  for (const Panels& good :
       {make_sphere({.diameter = 1, .edge_length = 0.1}), fixtures::torus(2, 0.5, 30, 15), make_cylinder({.diameter = 1, .height = 2, .edge_length = 0.2})}) {
    const Surface as_given(good), turned(fixtures::reversed(good));
    CHECK(as_given.report().flipped == 0);
    CHECK(turned.report().flipped == 1);
    CHECK(turned.report().rewound == 0);
    CHECK(as_given.report().volume > 0);
    CHECK(turned.report().volume == fixtures::relative(as_given.report().volume, 1e-13));  // other order of the corners
  }
}

TEST_CASE("outward: the inner wall of a hollow sphere faces the cavity, whatever the winding of both") {
  const Panels outer = make_sphere({.diameter = 2, .edge_length = 0.15}), inner = scaled(outer, 0.5);
  for (const Panels& first : {outer, fixtures::reversed(outer)}) {
    for (const Panels& second : {inner, fixtures::reversed(inner)}) {
      for (const bool inner_first : {false, true}) {
        const Surface hollow(inner_first ? fixtures::joined(second, first) : fixtures::joined(first, second));
        CHECK(hollow.report().cavities == 1);
        CHECK(hollow.report().components == 2);
        CHECK(hollow.report().volume == fixtures::relative(Surface(outer).report().volume * 7 / 8, 1e-13));  // rounding
        const Panels wound = panels_of(hollow);
        CHECK(fixtures::winding_number(wound, {0, 0.1, 0}) == fixtures::absolute(0, 1e-12, "1"));
        CHECK(fixtures::winding_number(wound, {0, 0.75, 0}) == fixtures::relative(1, 1e-12));
      }
    }
  }
}

TEST_CASE("outward: a ball in the cavity of a ball is solid again, unaffected by a second cavity beside it") {
  const Panels ball = make_box({.size = {1, 1, 1}, .edge_length = 0.25});
  Panels all = scaled(ball, 10);
  all = fixtures::joined(all, scaled(ball, 6, {-1.5, 0, 0}));  // a hollow
  all = fixtures::joined(all, scaled(ball, 2, {-2, 0.5, 0}));  // a solid in it
  all = fixtures::joined(all, scaled(ball, 1, {-2, 0.5, 0}));  // hollow
  all = fixtures::joined(all, scaled(ball, 2, {3.5, 0, 0}));   // another hollow in the first
  all = fixtures::joined(all, scaled(ball, 3, {20, 0, 0}));    // elsewhere
  const Surface surface(all);
  CHECK(surface.report().cavities == 3);
  CHECK(surface.report().volume == fixtures::relative(1000 - 216 + 8 - 1 - 8 + 27, 1e-12));  // rounding
}

TEST_CASE("outward: a blade embedded in a hub, or in the arm of an angle profile, stays solid") {
  const Panels hub = make_cylinder({.diameter = 2, .height = 2, .edge_length = 0.3});
  const Panels blade = fixtures::moved(make_box({.size = {0.2, 2, 0.5}, .edge_length = 0.1}), [](const Vec3d& v) { return v + Vec3d{0, 1.2, 0}; });
  const Surface propeller(fixtures::joined(hub, fixtures::reversed(blade)));
  CHECK(propeller.report().cavities == 0);
  CHECK(propeller.report().flipped == 1);

  // The bounding box of an angle profile contains all of a bar that extends beyond the profile at the inner corner.
  const Panels angle{
      {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}, {0, 0, 4}, {4, 0, 4}, {4, 1, 4}, {1, 1, 4}, {1, 4, 4}, {0, 4, 4}},
      {{0, 3, 2, 1}, {0, 5, 4, 3}, {6, 7, 8, 9}, {6, 9, 10, 11}, {0, 1, 7, 6}, {1, 2, 8, 7}, {2, 3, 9, 8}, {3, 4, 10, 9}, {4, 5, 11, 10}, {5, 0, 6, 11}}};
  CHECK(Surface(angle).report().volume == fixtures::relative(28, 1e-12));
  const Panels bar = scaled(make_box({.size = {1, 1, 1}, .edge_length = 0.25}), 1, {1.1, 1.1, 2});
  CHECK(Surface(fixtures::joined(angle, bar)).report().cavities == 0);
  CHECK(Surface(fixtures::joined(angle, scaled(bar, 1, {-0.6, -0.6, 0}))).report().cavities == 1);  // wholly in the corner
  CHECK(Surface(fixtures::joined(angle, scaled(bar, 1, {1.5, 1.5, 0}))).report().cavities == 0);    // in the box, outside the angle
}

TEST_CASE("outward: rays through vertices and along edges of the outer wall do not mislead") {
  // both boxes have the same lattice planes, so the ray from every centroid has y or z of the outer box's vertices or diagonals
  const Panels outer = make_box({.size = {3, 3, 3}, .edge_length = 0.125}), inner = make_box({.size = {1.5, 1.5, 1.5}, .edge_length = 0.375});
  CHECK(Surface(fixtures::joined(outer, inner)).report().cavities == 1);
  CHECK(Surface(fixtures::joined(outer, scaled(inner, 1, {3, 0, 0}))).report().cavities == 0);
}

TEST_CASE("orientation: a closed surface that is declared as reversed is refused with the ways to build a container, and one of its normals is accepted") {
  for (const Panels& panels : {fixtures::unit_cube(), make_sphere({.diameter = 1, .edge_length = 0.3})}) {
    CHECK_THROWS_WITH_AS(Surface(panels, {.orientation = Orientation::reversed, .name = "tank"}),
                         "tank: the surface is closed, so its outside is known, and cannot be declared as reversed; omit the orientation, or for a container "
                         "leave one side open, such as its lid, or give its walls a thickness by a second surface inside.",
                         InputError);
    CHECK(Surface(panels, {.orientation = Orientation::normals}).is_closed());
  }
}
