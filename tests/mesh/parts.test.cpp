#include <doctest/doctest.h>

#include <cmath>

#include "base/error.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/part_naming.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

TEST_CASE("parts: names apply to the panels added after them, repeated names are one part, empty parts are dropped") {
  Panels panels;
  PartNaming parts(panels);
  panels.add_triangle(0, 1, 2);
  parts.begin("hub");
  panels.add_triangle(1, 2, 3);
  panels.add_quad(1, 2, 3, 4);
  parts.begin("nothing");
  parts.begin("blade");
  panels.add_triangle(2, 3, 4);
  parts.begin("hub");
  panels.add_triangle(3, 4, 5);
  parts.finish();
  CHECK(panels.part_names == std::vector<std::string>{"", "hub", "blade"});
  CHECK(panels.part == std::vector{0, 1, 1, 2, 1});
}

TEST_CASE("parts: a surface of unnamed panels has one unnamed part") {
  Panels panels = fixtures::unit_cube();
  const Surface cube(panels);
  REQUIRE(cube.part_names().size() == 1);
  CHECK(cube.part_names()[0].empty());
  CHECK(cube.part_of_panel(5) == 0);
  CHECK(cube.report().parts[0].panels == 6);
  CHECK(cube.report().parts[0].area == fixtures::relative(6, 1e-14));
  PartNaming parts(panels);
  parts.finish();
  CHECK(panels.part.empty());
}

TEST_CASE("parts: they stay with their panels through welding, splitting, flipping and dropping") {
  // two cubes inside out; one has a panel without area and one that repeats another, both of a part that thereby vanishes
  Panels one = fixtures::unit_cube(), other = fixtures::moved(fixtures::unit_cube(), [](const Vec3d&p) { return 2.0 * p + Vec3d{5, 0, 0}; });
  one.panels.insert(one.panels.begin(), {0, 0, 1, -1});
  one.panels.push_back(one.panels[1]);
  one.part = {1, 0, 0, 0, 0, 0, 0, 1}, one.part_names = {"small", "dropped"};
  const Panels panels = fixtures::joined(fixtures::reversed(one), fixtures::reversed(other));
  const Surface surface(panels);
  CHECK(surface.report().duplicate == 2);
  CHECK(surface.report().degenerate == 1);
  CHECK(surface.report().flipped == 2);
  CHECK(std::vector<std::string>(surface.part_names().begin(), surface.part_names().end()) == std::vector<std::string>{"small", "dropped", ""});
  for (const Triangle& triangle : surface.triangles()) {
    const bool is_other = surface.vertices()[static_cast<std::size_t>(triangle.vertex[0])].x >= 5;
    CHECK((surface.part_of_panel(triangle.panel) == 2) == is_other);
  }
  CHECK(surface.report().parts[2].area == fixtures::relative(24, 1e-14));
  CHECK(surface.report().parts[0].area == fixtures::relative(6, 1e-14));
  CHECK(surface.report().parts[1].area == 0);
  CHECK(surface.report().parts[1].panels == 2);
}

TEST_CASE("parts: a cylinder has a side, a bottom and a top, whatever its axis") {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const Surface cylinder(make_cylinder({.diameter = 1, .height = 2, .axis = axis, .edge_length = 0.05}));
    const auto direction = static_cast<std::size_t>(axis);
    REQUIRE(cylinder.part_names().size() == 3);
    for (const Triangle& triangle : cylinder.triangles()) {
      const std::string& part = cylinder.part_names()[static_cast<std::size_t>(cylinder.part_of_panel(triangle.panel))];
      const double along = cylinder.normal(static_cast<std::size_t>(&triangle - cylinder.triangles().data()))[direction];
      CHECK(part == (along > 0.5 ? "top" : along < -0.5 ? "bottom" : "side"));
    }
  }
}

TEST_CASE("parts: lists of the wrong length are rejected") {
  Panels panels = fixtures::unit_cube();
  panels.part_names = {"a"};
  panels.part = {0, 0, 0};
  CHECK_THROWS_WITH_AS(Surface{panels}, "surface: 3 of the 6 panels have a part; give one to each, or to none.", InputError);
  panels.part = {0, 0, 0, 0, 0, 1};
  CHECK_THROWS_WITH_AS(Surface{panels}, "surface: panel 5 belongs to part 1, but there are names of 1 parts only; correct the part numbers.", InputError);
}

TEST_CASE("parts: components with intersecting boxes may overlap, cavities and separate neighbours do not") {
  const auto cube = [](double size, const Vec3d& low) { return fixtures::moved(fixtures::unit_cube(), [=](const Vec3d& p) { return size * p + low; }); };
  CHECK(Surface(fixtures::unit_cube()).report().may_overlap == 0);
  CHECK(Surface(fixtures::joined(cube(1, {}), cube(1, {1.5, 0, 0}))).report().may_overlap == 0);
  CHECK(Surface(fixtures::joined(cube(1, {}), cube(1, {0.5, 0.5, 0.5}))).report().may_overlap == 2);
  CHECK(Surface(fixtures::joined(cube(1, {}), cube(0.5, {0.25, 0.25, 0.25}))).report().may_overlap == 0);  // a hollow
  CHECK(Surface(fixtures::joined(fixtures::joined(cube(1, {}), cube(1, {0.5, 0.5, 0.5})), cube(1, {0.6, 5, 0}))).report().may_overlap == 2);
}
