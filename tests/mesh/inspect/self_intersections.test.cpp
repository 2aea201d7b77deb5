#include "mesh/inspect/self_intersections.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/threads.hpp"
#include "mesh/inspect/crossing_triangles.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;

namespace {

/// A tube about a figure of eight in the plane z = 0, which intersects itself in the middle.
Panels figure_of_eight() {
  Panels out = fixtures::torus(2, 0.3, 120, 16);
  for (int i = 0; i < 120; ++i) {
    const double u = 2 * std::numbers::pi * i / 120;
    const Vec3d on_curve{2 * std::sin(u), std::sin(2 * u), 0}, along{2 * std::cos(u), 2 * std::cos(2 * u), 0};
    const Vec3d aside = Vec3d{along.y, -along.x, 0} / norm(along);
    for (int j = 0; j < 16; ++j) {
      const double v = 2 * std::numbers::pi * j / 16;
      out.vertices[std::size_t(16 * i + j)] = on_curve + 0.3 * (std::cos(v) * aside + std::sin(v) * Vec3d{0, 0, 1});
    }
  }
  return out;
}

/// A sphere of radius 1 whose top is pushed down by `depth`.
Panels dented_sphere(double depth) {
  Panels out = make_sphere({.diameter = 2, .edge_length = 0.1});
  for (Vec3d& v : out.vertices) v.z -= depth * std::max(0.0, 2 * v.z - 1);
  return out;
}

SelfIntersections inspect(const Surface& surface) { return self_intersections(surface, Bvh(surface)); }

std::size_t crossings_of_all_pairs(const Surface& surface) {
  const auto corners = [&](std::size_t t) { return TriangleCorners{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}; };
  std::size_t count = 0;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    for (std::size_t u = t + 1; u < surface.triangles().size(); ++u) count += crossing_of(corners(t), corners(u)) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("self-intersections: none are found in bodies without, in any orientation") {
  for (const Panels& panels : {make_sphere({.diameter = 1, .edge_length = 0.1}), make_box({.size = {1, 2, 3}, .edge_length = 0.2, .panels = PanelKind::quads}),
                               fixtures::torus(2, 0.5, 48, 24), dented_sphere(1)}) {
    const SelfIntersections found = inspect(Surface(panels));
    CHECK(found.crossings == 0);
    CHECK(found.defects.empty());
  }
}

TEST_CASE("self-intersections: a tube that intersects itself is reported, as by a loop over all pairs, and may be used") {
  const Surface surface(figure_of_eight());
  const SelfIntersections found = inspect(surface);
  CHECK(found.crossings == crossings_of_all_pairs(surface));
  CHECK(found.crossings > 20);
  REQUIRE(found.defects.size() == 1);
  CHECK(found.defects[0].kind == DefectKind::self_intersection);
  for (const int panel : found.defects[0].panels) {
    const auto& p = surface.panels().panels[std::size_t(panel)];
    CHECK(norm(surface.panels().vertices[std::size_t(p[0])]) < 1);  // it is where the figure crosses
  }
  CHECK_NOTHROW(expect_no_pockets(found, "tube"));
}

TEST_CASE("self-intersections: a dent that emerges on the other side is inside out, and rejected with its panels") {
  const Surface surface(dented_sphere(3));
  const SelfIntersections found = inspect(surface);
  CHECK(found.crossings == crossings_of_all_pairs(surface));
  REQUIRE(found.defects.size() == 1);
  CHECK(found.defects[0].kind == DefectKind::inside_out);
  const std::string expected = "bowl: " + std::to_string(found.defects[0].panels.size()) +
                               " panels intersect such that the surface is inside out between them, the first is panel " +
                               std::to_string(found.defects[0].panels.front()) +
                               " (counted from 0): a particle could enter there without crossing a front; repair the fold where these panels intersect.";
  CHECK_THROWS_WITH_AS(expect_no_pockets(found, "bowl"), expected.c_str(), SurfaceError);
}

TEST_CASE("self-intersections: overlapping bodies are not counted") {
  Panels two = make_box({.size = {1, 1, 1}, .edge_length = 0.3});
  const Panels box = two;
  const int first = int(box.vertices.size());
  for (const Vec3d& v : box.vertices) two.vertices.push_back(v + Vec3d{0.45, 0.35, 0.25});
  for (const auto& p : box.panels) two.add_triangle(p[0] + first, p[1] + first, p[2] + first);
  const Surface surface(two);
  CHECK(crossings_of_all_pairs(surface) > 0);
  CHECK(inspect(surface).crossings == 0);
}

TEST_CASE("self-intersections: identical on one thread and on four") {
  const Surface surface(figure_of_eight());
  const fixtures::Threads with_one(1);
  const SelfIntersections one = inspect(surface);
  const fixtures::Threads with_four(4);
  const SelfIntersections four = inspect(surface);
  CHECK(one.crossings == four.crossings);
  CHECK(one.defects[0].panels == four.defects[0].panels);
}

TEST_CASE("self-intersections: a body that is inside out is reported beside an open sheet too") {
  Panels panels = dented_sphere(3);
  const int first = int(panels.vertices.size());
  panels.vertices.insert(panels.vertices.end(), {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}});
  panels.add_triangle(first, first + 1, first + 2);
  const SelfIntersections found = inspect(Surface(panels, {.orientation = Orientation::normals}));
  REQUIRE(found.defects.size() == 1);
  CHECK(found.defects[0].kind == DefectKind::inside_out);
}
