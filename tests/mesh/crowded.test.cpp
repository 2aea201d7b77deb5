// Non-manifold edges and coincident panels: resolved or rejected.
#include <doctest/doctest.h>

#include <algorithm>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/defects.hpp"
#include "mesh/duplicates.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

void add(Panels& to, const Panels& more, const Vec3d& shift) {
  const int first = int(to.vertices.size());
  for (const Vec3d& v : more.vertices) to.vertices.push_back(v + shift);
  for (auto panel : more.panels) {
    for (int& v : panel) v += v >= 0 ? first : 0;
    to.panels.push_back(panel);
  }
}

Panels reversed(Panels panels) {
  for (auto& p : panels.panels) std::swap(p[1], p[3] < 0 ? p[2] : p[3]);
  return panels;
}

Surface open_surface(const Panels& panels) { return Surface(panels, {.orientation = Orientation::normals, .name = "hull"}); }

}  // namespace

TEST_CASE("non-manifold: boxes that share a face become one body, without the wall between them") {
  for (const double panel : {1.0, 0.25}) {
    const Panels box = make_box({.size = {1, 1, 1}, .edge_length = panel});
    Panels two = box;
    add(two, box, {1, 0, 0});
    const Surface surface(two);
    CHECK(surface.is_closed());
    CHECK(surface.report().components == 1);
    CHECK(surface.report().volume == fixtures::relative(2, 1e-12));
    CHECK(surface.report().area == fixtures::relative(10, 1e-12));
    CHECK(surface.report().back_to_back == 2 * 2 * std::size_t(1 / panel) * std::size_t(1 / panel));
    CHECK(surface.report().boundary_edges == 0);
  }
}

TEST_CASE("non-manifold: boxes that share an edge are connected there, and their outside is outside") {
  const Panels box = make_box({.size = {1, 1, 1}, .edge_length = 0.5});
  Panels two = box;
  add(two, box, {1, 1, 0});
  const Surface surface(two);
  CHECK(surface.is_closed());
  CHECK(surface.report().non_manifold_edge_count == 2);
  CHECK(surface.report().cut_edges == 0);
  CHECK(surface.report().volume == fixtures::relative(2, 1e-12));
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d middle = (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3.0;
    const Vec3d of_box = middle.x + middle.y < 1 ? Vec3d{0, 0, 0} : Vec3d{1, 1, 0};
    CHECK(dot(surface.normal(t), middle - of_box) > 0);
    for (std::size_t e = 0; e < 3; ++e) {
      const int beyond = surface.neighbour(t, e);
      REQUIRE(beyond >= 0);
      const auto& back = surface.triangles()[std::size_t(beyond)];
      CHECK((surface.neighbour(std::size_t(beyond), 0) == int(t) || surface.neighbour(std::size_t(beyond), 1) == int(t) ||
             surface.neighbour(std::size_t(beyond), 2) == int(t)));
      CHECK(back.vertex != surface.triangles()[t].vertex);
    }
  }
}

TEST_CASE("non-manifold: an inner wall is rejected with its panels, or cut off if the orientation is declared, and the outer walls stay whole") {
  Panels cube = make_box({.size = {1, 1, 1}, .edge_length = 0.5});
  Panels wall;  // across the middle, y = 0
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) wall.vertices.push_back({0.5 * i - 0.5, 0, 0.5 * j - 0.5});
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) wall.add_quad(3 * i + j, 3 * i + 3 + j, 3 * i + 4 + j, 3 * i + 1 + j);
  const int first = int(cube.panels.size());
  add(cube, wall, {0, 0, 0});
  try {
    const Surface surface(cube, {.name = "hull"});
    FAIL("it was taken");
  } catch (const SurfaceError& error) {
    CHECK(std::string(error.what()).starts_with("hull: the surface is non-manifold: 8 edges have more than two panels, the first from ("));
    CHECK(std::string(error.what())
              .ends_with("so their connection is ambiguous; delete inner walls, or use it as an open surface that is cut along "
                         "these edges, with Surface::Options::orientation, Orientation::normals (the side that the normals point to)."));
    CHECK(error.in_words_of({.cut_open = "as you like"}).ends_with("cut along these edges, as you like."));
    CHECK(error.defect().kind == DefectKind::non_manifold);
    CHECK(error.defect().panels == std::vector<int>{first, first + 1, first + 2, first + 3});
  }
  const Surface surface = open_surface(cube);
  CHECK_FALSE(surface.is_closed());
  CHECK(surface.report().cut_edges == 8);
  CHECK(surface.report().boundary_edges == 8);
  CHECK(surface.report().components == 2);
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    if (surface.triangles()[t].panel >= first) continue;
    for (std::size_t e = 0; e < 3; ++e) CHECK(surface.neighbour(t, e) >= 0);
  }
}

TEST_CASE("non-manifold: a panel that both halves of a hull contain in their common plane is removed") {
  // a tetrahedral body with a triangle of no thickness beyond one of its edges
  Panels body = make_box({.size = {1, 1, 1}, .edge_length = 0.02});
  const int tip = int(body.vertices.size());
  const auto at = [&](const Vec3d& place) {
    for (std::size_t v = 0; v < body.vertices.size(); ++v)
      if (norm(body.vertices[v] - place) < 1e-9) return int(v);
    return -1;
  };
  const int a = at({-0.5, 0.5, 0.0}), b = at({-0.5, 0.5, 0.02});
  REQUIRE(a >= 0);
  REQUIRE(b >= 0);
  body.vertices.push_back({-0.51, 0.51, 0.01});
  body.add_triangle(a, b, tip);
  body.add_triangle(b, a, tip);
  const Surface surface(body);
  CHECK(surface.is_closed());
  CHECK(surface.report().back_to_back == 2);
  CHECK(surface.report().volume == fixtures::relative(1, 1e-12));

  body.vertices[std::size_t(tip)] = {-1.5, 1.5, 0.01};  // a fin that is large enough to be intended
  CHECK_THROWS_AS(Surface{body}, SurfaceError);
  CHECK(open_surface(body).report().back_to_back == 0);
}

TEST_CASE("non-manifold: a sheet given from both sides is kept once") {
  const Panels box = make_box({.size = {1, 1, 1}, .edge_length = 0.5});
  Panels sheet{box.vertices, {}, {}, {}};
  for (const auto& p : box.panels)
    if (box.vertices[std::size_t(p[0])].z > 0.4 && box.vertices[std::size_t(p[1])].z > 0.4 && box.vertices[std::size_t(p[2])].z > 0.4)
      sheet.panels.push_back(p);
  const std::size_t panels = sheet.panels.size();
  REQUIRE(panels == 8);
  const Panels back = reversed(sheet);
  sheet.panels.insert(sheet.panels.end(), back.panels.begin(), back.panels.end());
  const Surface surface = open_surface(sheet);
  CHECK(surface.report().triangles == panels);
  CHECK(surface.report().duplicate == panels);
  CHECK(surface.report().back_to_back == 0);
  CHECK(surface.report().area == fixtures::relative(1, 1e-12));
}

TEST_CASE("non-manifold: a repeated panel is removed whatever its winding, and a third coincident one too") {
  Panels cube = fixtures::unit_cube();
  cube.panels.push_back(cube.panels[2]);
  const Surface twice(cube);
  CHECK(twice.report().duplicate == 2);
  CHECK(twice.is_closed());
  cube.panels.push_back(cube.panels[2]);
  CHECK(Surface(cube).report().duplicate == 4);
}

TEST_CASE("non-manifold: a wall with a part given from both sides keeps this part, closed and open") {
  Panels cube = make_box({.size = {1, 1, 1}, .edge_length = 0.5, .panels = PanelKind::quads});
  auto back = cube.panels[3];
  std::swap(back[1], back[3]);
  cube.panels.push_back(back);
  const Surface closed(cube);
  CHECK(closed.is_closed());
  CHECK(closed.report().back_to_back == 0);
  CHECK(closed.report().volume == fixtures::relative(1, 1e-12));
  cube.panels.erase(cube.panels.begin() + 12);
  CHECK(open_surface(cube).report().boundary_edges == 4);
}

TEST_CASE("non-manifold: parts of squares share a face whatever the first corner of its panels") {
  const Panels box = make_box({.size = {1, 1, 1}, .edge_length = 0.5, .panels = PanelKind::quads});
  for (std::size_t turn = 0; turn < 4; ++turn) {
    Panels other = box;
    for (auto& p : other.panels) std::rotate(p.begin(), p.begin() + std::ptrdiff_t(turn), p.end());
    Panels two = box;
    add(two, other, {1, 0, 0});
    const Surface surface(two);
    CHECK(surface.is_closed());
    CHECK(surface.report().volume == fixtures::relative(2, 1e-12));
    Panels twice = box;
    twice.panels.push_back(other.panels[5]);
    CHECK(Surface(twice).report().duplicate == 2);
  }
}

TEST_CASE("non-manifold: an inner wall of a hull with inward normals leaves its outer wall whole too") {
  Panels cube = reversed(make_box({.size = {1, 1, 1}, .edge_length = 0.5}));
  const int first = int(cube.panels.size());
  Panels wall{{{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0.5, 0, 0.5}, {-0.5, 0, 0.5}, {0, 0, -0.5}, {0.5, 0, 0}, {0, 0, 0.5}, {-0.5, 0, 0}, {0, 0, 0}}, {}, {}, {}};
  for (const auto& quad : {std::array{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}}) wall.panels.push_back(quad);
  add(cube, wall, {0, 0, 0});
  const Surface surface(cube, {.orientation = Orientation::reversed, .name = "hull"});
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    if (surface.triangles()[t].panel >= first) continue;
    for (std::size_t e = 0; e < 3; ++e) CHECK(surface.neighbour(t, e) >= 0);
  }
}
