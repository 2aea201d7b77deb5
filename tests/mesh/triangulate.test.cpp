#include "mesh/triangulate.hpp"

#include <doctest/doctest.h>

#include "base/quaternion.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

Triangulation cut(const std::vector<Vec3d>& vertices, const std::vector<std::array<int, 4>>& panels) { return triangulate({vertices, panels}, 1e-9); }

bool shares(const Triangulation& triangulation, int a, int b) {
  return std::all_of(triangulation.triangles.begin(), triangulation.triangles.end(), [&](const Triangle& t) {
    const auto has = [&](int v) { return std::find(t.vertex.begin(), t.vertex.end(), v) != t.vertex.end(); };
    return has(a) && has(b);
  });
}

/// A unit cube with more vertices on its edge from (0,0,0) to (1,0,0): the face y = 0 has triangles to each, and the face z = 0 ends on
/// the straight edge, with slivers between.
Panels cube_with_slivers(int inserted) {
  Panels cube = fixtures::unit_cube();
  std::vector<int> edge{0};
  for (int k = 1; k <= inserted; ++k) {
    edge.push_back(int(cube.vertices.size()));
    cube.vertices.push_back({double(k) / (inserted + 1), 0, 0});
  }
  edge.push_back(1);
  cube.panels.erase(cube.panels.begin() + 2);  // y = 0: 0, 1, 5, 4
  for (std::size_t k = 0; k + 1 < edge.size(); ++k) cube.add_triangle(edge[k], edge[k + 1], 4);
  cube.add_triangle(1, 5, 4);
  for (std::size_t k = 1; k + 1 < edge.size(); ++k) cube.add_triangle(edge[0], edge[k + 1], edge[k]);  // a fan of slivers
  return cube;
}

}  // namespace

TEST_CASE("triangulate: a quad is split along its shorter diagonal") {
  const auto kite = cut({{0, 0, 0}, {1, -0.5, 0}, {3, 0, 0}, {1, 0.5, 0}}, {{0, 1, 2, 3}});
  CHECK(kite.triangles.size() == 2);
  CHECK(shares(kite, 1, 3));
  CHECK(shares(cut({{0, 0, 0}, {1, -2, 0}, {2, 0, 0}, {1, 2, 0}}, {{0, 1, 2, 3}}), 0, 2));
  CHECK(shares(cut({{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, -0.1}}, {{0, 1, 2, 3}}), 0, 2));  // warped: √2 against more
}

TEST_CASE("triangulate: rounding does not choose the diagonal of a rectangle") {
  for (int k = 0; k < 100; ++k) {
    const Mat3 turn = Quaternion::from_rotation({0.1 * k, 0.3, -0.02 * k}).matrix();
    CHECK(shares(cut({turn * Vec3d{0, 0, 0}, turn * Vec3d{0.1, 0, 0}, turn * Vec3d{0.1, 0.3, 0}, turn * Vec3d{0, 0.3, 0}}, {{0, 1, 2, 3}}), 0, 2));
  }
}

TEST_CASE("triangulate: a re-entrant quad is split from its re-entrant corner, although that diagonal is longer") {
  const auto dart = cut({{0, 0, 0}, {10, 1, 0}, {8, 0, 0}, {10, -1, 0}}, {{0, 1, 2, 3}});
  CHECK(shares(dart, 0, 2));
}

TEST_CASE("triangulate: a quad with a corner on a straight side loses no area") {
  const auto quad = cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 5, 0}}, {{0, 1, 2, 3}});
  CHECK(quad.triangles.size() == 2);
  CHECK(quad.degenerate == 0);
  CHECK(shares(quad, 1, 3));
}

TEST_CASE("triangulate: a quad with a repeated corner is a triangle") {
  for (const std::array<int, 4>& quad : {std::array{0, 1, 2, 2}, std::array{0, 0, 1, 2}, std::array{0, 1, 1, 2}, std::array{0, 1, 2, 0}}) {
    const auto triangulation = cut({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {quad});
    CHECK(triangulation.triangles.size() == 1);
    CHECK(triangulation.degenerate == 1);
  }
}

TEST_CASE("triangulate: repeated panels are dropped whatever the order of their corners") {
  const auto repeated = cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, -1}, {1, 2, 0, -1}, {0, 2, 1, -1}, {0, 1, 3, -1}});
  CHECK(repeated.duplicate == 2);
  CHECK(repeated.triangles.size() == 2);
  CHECK(repeated.triangles[0].panel == 0);
  CHECK(repeated.triangles[1].panel == 3);
}

TEST_CASE("slivers: on a straight edge they leave no boundary edge, whether one, twenty or ninety") {
  for (const int inserted : {1, 2, 3, 20, 90}) {
    const Surface cube(cube_with_slivers(inserted));
    CHECK(cube.is_closed());
    CHECK(cube.report().degenerate == std::size_t(inserted));
    CHECK(cube.report().vertices == std::size_t(8 + inserted));
    CHECK(cube.report().volume == fixtures::relative(1, 1e-14));  // rounding of some hundred terms
    CHECK(cube.report().area == fixtures::relative(6, 1e-14));
    for (std::size_t t = 0; t < cube.triangles().size(); ++t) CHECK(largest_magnitude(cube.normal(t)) == 1);  // all faces are axis-aligned
  }
}

TEST_CASE("slivers: two that share their longest side are absorbed as well") {
  // the edge of the cube has a different vertex on either face
  Panels cube = cube_with_slivers(1);
  cube.panels.erase(std::find(cube.panels.begin(), cube.panels.end(), std::array{0, 2, 3, 1}));  // z = 0
  cube.vertices.push_back({0.25, 0, 0});
  const int m = int(cube.vertices.size()) - 1;
  cube.add_triangle(0, 2, m);
  cube.add_triangle(m, 2, 3);
  cube.add_triangle(m, 3, 1);
  cube.add_triangle(0, m, 1);
  const Surface surface(cube);
  CHECK(surface.is_closed());
  CHECK(surface.report().degenerate == 2);
  CHECK(surface.report().volume == fixtures::relative(1, 1e-14));
}

TEST_CASE("slivers: a triangle with one on each side absorbs them one after the other") {
  // a tetrahedron whose base ends on straight edges with a vertex in the middle of each, which the other faces use
  const std::vector<Vec3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}};
  Panels body{vertices, {{0, 2, 1, -1}}};
  constexpr int sides[3][3] = {{0, 4, 1}, {1, 5, 2}, {2, 6, 0}};
  for (const auto& [from, middle, to] : sides) {
    body.add_triangle(from, middle, 3);
    body.add_triangle(middle, to, 3);
    body.add_triangle(from, to, middle);
  }
  const Surface surface(body);
  CHECK(surface.is_closed());
  CHECK(surface.report().degenerate == 3);
  CHECK(surface.report().volume == fixtures::relative(1 / 6.0, 1e-14));  // rounding of ten terms
}

TEST_CASE("slivers: one at a boundary edge is dropped") {
  const Panels sheet{{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3, -1}, {1, 2, 3, -1}, {0, 2, 1, -1}}};
  const Surface surface(sheet, {.orientation = Orientation::normals, .name = "sheet"});
  CHECK(surface.report().degenerate == 1);
  CHECK(surface.report().triangles == 2);
}
