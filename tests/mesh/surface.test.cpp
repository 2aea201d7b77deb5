#include "mesh/surface.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <sstream>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;
using doctest::Contains;

namespace {

Surface named(const Panels& panels, Orientation outside = Orientation::undeclared) { return Surface(panels, {.orientation = outside, .name = "hull"}); }

/// Panels and the complete message that rejects them.
void check_refused(const Panels& panels, const char* sentence) { CHECK_THROWS_WITH_AS(named(panels), sentence, InputError); }

}  // namespace

TEST_CASE("surface: a cube of quads is closed, with eight vertices and twelve triangles with panel numbers") {
  const Surface cube = named(fixtures::unit_cube());
  const SurfaceReport& report = cube.report();
  CHECK(cube.is_closed());
  CHECK(report.panels == 6);
  CHECK(report.triangles == 12);
  CHECK(report.vertices == 8);
  CHECK(report.components == 1);
  CHECK(report.welded + report.degenerate + report.duplicate + report.rewound + report.flipped + report.cavities + report.boundary_edges == 0);
  CHECK(report.area == 6);
  CHECK(report.shortest_edge == 1);
  CHECK(report.longest_edge == std::sqrt(2.0));
  CHECK(report.bounds.low == Vec3d{0, 0, 0});
  CHECK(report.bounds.high == Vec3d{1, 1, 1});
  for (std::size_t t = 0; t < 12; ++t) CHECK(cube.triangles()[t].panel == int(t / 2));
  CHECK(cube.radius_about({0, 0, 0}) == std::sqrt(3.0));
}

TEST_CASE("surface: neighbours are mutual and share the edge") {
  for (const Panels& panels : {fixtures::unit_cube(), fixtures::exploded(fixtures::torus(2, 0.5, 20, 10)), make_sphere({.diameter = 1, .edge_length = 0.1})}) {
    const Surface surface = named(panels);
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      for (std::size_t e = 0; e < 3; ++e) {
        REQUIRE(surface.neighbour(t, e) >= 0);
        const auto u = static_cast<std::size_t>(surface.neighbour(t, e));
        int common = 0;
        for (std::size_t f = 0; f < 3; ++f) {
          const bool same_edge = surface.triangles()[u].vertex[f] == surface.triangles()[t].vertex[(e + 1) % 3] &&
                                 surface.triangles()[u].vertex[(f + 1) % 3] == surface.triangles()[t].vertex[e];
          common += same_edge && surface.neighbour(u, f) == int(t) ? 1 : 0;
        }
        CHECK(common == 1);
      }
    }
  }
}

TEST_CASE("surface: the Euler characteristic distinguishes sphere and torus after welding") {
  const auto euler = [](const Panels& panels) {
    const SurfaceReport report = named(panels).report();
    return int(report.vertices) - int(3 * report.triangles / 2) + int(report.triangles);
  };
  CHECK(euler(fixtures::exploded(fixtures::unit_cube())) == 2);
  CHECK(euler(fixtures::exploded(make_sphere({.diameter = 1, .edge_length = 0.1}))) == 2);
  CHECK(euler(fixtures::exploded(fixtures::torus(2, 0.5, 24, 12, 1))) == 0);
}

TEST_CASE("surface: an open one must declare its orientation, and the message states how") {
  Panels box = fixtures::unit_cube();
  box.panels.erase(box.panels.begin() + 1);  // the lid
  check_refused(box,
                "hull: the surface is open: 4 edges belong to one panel only, the first to panel 1 (counted from 0); close the holes, or specify which side is "
                "outside with "
                "Surface::Options::orientation, Orientation::normals (the one that the normals point to) or Orientation::reversed.");
  const Surface as_given = named(box, Orientation::normals), turned = named(box, Orientation::reversed);
  CHECK_FALSE(as_given.is_closed());
  CHECK(as_given.report().boundary_edges == 4);
  CHECK(as_given.report().vertices == 8);
  CHECK(as_given.report().volume == 0);
  CHECK(as_given.report().centroid.z == fixtures::relative(0.4, 1e-12));  // four walls of ½ and a floor of 0, by hand
  for (std::size_t t = 0; t < as_given.triangles().size(); ++t) {
    CHECK(as_given.normal(t) == -turned.normal(t));
    CHECK(dot(as_given.normal(t), as_given.corner(t, 0) - Vec3d{0.5, 0.5, 0.5}) > 0);
  }
}

TEST_CASE("surface: the boundary consists of edges and vertices, never faces") {
  Panels box = fixtures::unit_cube();
  box.panels.erase(box.panels.begin() + 1);  // z = 1
  const Surface surface = named(box, Orientation::normals);
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    CHECK_FALSE(surface.is_boundary_edge(t, Feature::face));
    for (std::size_t c = 0; c < 3; ++c) {
      const bool at_top = surface.corner(t, c).z == 1, next_at_top = surface.corner(t, (c + 1) % 3).z == 1;
      CHECK(surface.is_boundary_edge(t, static_cast<Feature>(4 + c)) == at_top);
      CHECK(surface.is_boundary_edge(t, static_cast<Feature>(1 + c)) == (at_top && next_at_top));
    }
  }
}

TEST_CASE("surface: an edge with three panels is rejected with their numbers") {
  Panels cube = fixtures::unit_cube();
  cube.panels.push_back({0, 1, 7, 6});  // an inner wall from one edge to the opposite one; its sides are diagonals of the faces
  check_refused(
      cube,
      "hull: the surface is non-manifold: 4 edges have more than two panels, the first from (0, 0, 0) to (1, 0, 0) m with the panels 0, 2, 6 (counted from 0), "
      "so their connection is ambiguous; delete inner walls, or use it as an open surface that is cut along these edges, with "
      "Surface::Options::orientation, Orientation::normals (the side that the normals point to).");
}

TEST_CASE("surface: a quad with a wall along its diagonal is listed once") {
  Panels sail{{{0, -1, 0}, {3, 0, 0}, {0, 1, 0}, {-3, 0, 0}, {0, 0, 1}}, {}, {}, {}};
  sail.add_quad(0, 1, 2, 3);
  sail.add_triangle(0, 2, 4);
  CHECK_THROWS_WITH_AS(named(sail), Contains("from (0, -1, 0) to (0, 1, 0) m with the panels 0, 1 (counted from 0)"), InputError);
}

TEST_CASE("surface: a Möbius strip is rejected, a band with two half turns is not") {
  CHECK_THROWS_WITH_AS(named(fixtures::band(40, 1), Orientation::normals), Contains("close a Möbius strip, so the surface is not orientable"), InputError);
  CHECK_THROWS_AS(named(fixtures::band(40, 3), Orientation::normals), InputError);
  CHECK(named(fixtures::band(40, 0), Orientation::normals).report().boundary_edges == 80);
  CHECK(named(fixtures::band(40, 2), Orientation::normals).report().boundary_edges == 80);
}

TEST_CASE("surface: invalid panels are rejected with one sentence") {
  check_refused({}, "hull: the surface has no panels; check that the file or shape is the right one.");
  Panels cube = fixtures::unit_cube();
  cube.panels[3][2] = 8;
  check_refused(cube, "hull: panel 3 has the vertex 8, but there are only the vertices 0 to 7; correct the vertex numbers.");
  cube.panels[3] = {0, -1, 2, 3};
  check_refused(cube, "hull: panel 3 has the vertex -1, but there are only the vertices 0 to 7; correct the vertex numbers.");
  cube = fixtures::unit_cube();
  cube.vertices[5].y = std::numeric_limits<double>::quiet_NaN();
  check_refused(cube,
                "hull: vertex 5 (counted from 0) is at (1, nan, 1), which is not finite or out of range; each coordinate must be a finite number "
                "of metres.");
  cube.vertices[5].y = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(named(cube), InputError);
  cube.vertices[5].y = 1e300;  // finite, but its square is not
  CHECK_THROWS_AS(named(cube), InputError);
  check_refused({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2, -1}, {0, 0, 1, -1}}},
                "hull: none of the 2 panels has an area; check the file's scale and its coordinates.");
}

TEST_CASE("surface: a sheet with two sides and no thickness has no inside and is rejected") {
  // front and back meshed with different diagonals, so that their triangles are not duplicates
  const Panels sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, -1}, {0, 2, 3, -1}, {0, 3, 1, -1}, {1, 3, 2, -1}}};
  check_refused(
      sheet,
      "hull: the closed part with panel 0 (counted from 0) encloses no volume, so it has no inside; give it a thickness, or delete one of its two sides.");
}

TEST_CASE("surface: an unused vertex has no effect") {
  Panels cube = fixtures::unit_cube();
  cube.vertices.push_back({1e9, 0, 0});  // if it counted, the welding tolerance would be 1
  const Surface surface = named(cube);
  CHECK(surface.report().vertices == 8);
  CHECK(surface.report().bounds.high.x == 1);
}

TEST_CASE("surface: bodies whose tips meet in one vertex have that vertex twice") {
  const Panels one = fixtures::tetrahedron();
  const Panels other = fixtures::moved(one, [](const Vec3d& v) { return Vec3d{-v.x, -v.y, -v.z}; });  // inside out by the reflection
  const Surface surface = named(fixtures::joined(one, other));
  CHECK(surface.report().components == 2);
  CHECK(surface.report().welded == 1);
  CHECK(surface.report().vertices == 8);
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (surface.corner(t, c) != Vec3d{0, 0, 0}) continue;
      const double side = surface.triangles()[t].panel < 4 ? 1 : -1;
      CHECK(norm(surface.pseudonormal(t, static_cast<Feature>(4 + c)) + side / std::sqrt(3.0) * Vec3d{1, 1, 1}) < 1e-15);  // rounding
    }
  }
}

TEST_CASE("surface: construction is bitwise reproducible for any number of threads") {
  const Panels panels = fixtures::exploded(make_sphere({.diameter = 1, .edge_length = 0.02}));
  const fixtures::Threads with_one(1);
  const Surface alone = named(panels);
  const fixtures::Threads with_four(4);
  const Surface together = named(panels);
  CHECK(alone.report().volume == together.report().volume);
  CHECK(std::equal(alone.vertices().begin(), alone.vertices().end(), together.vertices().begin()));
}

TEST_CASE("surface: weld distances and tolerances that are negative or not finite are refused in a sentence") {
  for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::ostringstream sentence;
    sentence << " is " << wrong << ", but it must be a finite number of at least 0; 0 merges coincident vertices only.";
    CHECK_THROWS_WITH_AS(Surface(fixtures::unit_cube(), {.weld_distance = wrong}), ("surface: the weld distance" + sentence.str()).c_str(), InputError);
    CHECK_THROWS_WITH_AS(Surface(fixtures::unit_cube(), {.weld_tolerance = wrong}), ("surface: the weld tolerance" + sentence.str()).c_str(), InputError);
  }
}
