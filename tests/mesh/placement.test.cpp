#include "mesh/placement.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

Panels placed(Panels panels, const Placement& placement) {
  place(panels, placement);
  return panels;
}

constexpr double quarter = std::numbers::pi / 2;
constexpr double rounding = 1e-15;  // of a quarter turn of unit vectors

}  // namespace

TEST_CASE("placement: the identity leaves the panels bitwise identical") {
  const Panels torus = fixtures::torus(2, 0.5, 12, 8);
  const Panels same = placed(torus, {});
  CHECK(same.vertices == torus.vertices);
  CHECK(same.panels == torus.panels);
}

TEST_CASE("placement: rotation is about x, then y, then z, as fixed axes") {
  const auto turned = [](const Vec3d& point, const Vec3d& angles) { return placed({{point}, {}, {}, {}}, {.rotate = angles}).vertices[0]; };
  CHECK(norm(turned({0, 1, 0}, {quarter, 0, 0}) - Vec3d{0, 0, 1}) < rounding);
  CHECK(norm(turned({0, 0, 1}, {0, quarter, 0}) - Vec3d{1, 0, 0}) < rounding);
  CHECK(norm(turned({1, 0, 0}, {0, 0, quarter}) - Vec3d{0, 1, 0}) < rounding);
  // y goes to z by the first, to x by the second, to y by the third
  CHECK(norm(turned({0, 1, 0}, {quarter, quarter, quarter}) - Vec3d{0, 1, 0}) < 3 * rounding);
}

TEST_CASE("placement: scale comes before translation, and translation after rotation") {
  const Panels point{{{1, 0, 0}}, {}, {}, {}};
  CHECK(norm(placed(point, {.scale = 2, .rotate = {0, 0, quarter}, .translate = {10, 0, 0}}).vertices[0] - Vec3d{10, 2, 0}) < 10 * rounding);
}

TEST_CASE("placement: a mirrored body is still oriented outward, in triangles and in quads") {
  for (const PanelKind kind : {PanelKind::triangles, PanelKind::quads}) {
    Panels box = make_box({.size = {1, 2, 3}, .edge_length = 0.5, .panels = kind});
    for (Vec3d& v : box.vertices) v += Vec3d{5, 6, 7};
    for (const auto& [plane, centre] : {std::pair{MirrorPlane::x, Vec3d{-5, 6, 7}}, {MirrorPlane::y, {5, -6, 7}}, {MirrorPlane::z, {5, 6, -7}}}) {
      const Surface surface(placed(box, {.mirror = plane}));
      CHECK(norm(surface.report().centroid - centre) < 1e-13);
      CHECK(surface.report().flipped == 0);
      CHECK(surface.report().rewound == 0);
    }
  }
}

TEST_CASE("placement: half a ship becomes a whole one, with a wall in its plane or without, and keeps its parts") {
  Panels half = make_box({.size = {4, 1, 1}, .edge_length = 0.5, .panels = PanelKind::quads});
  for (Vec3d& v : half.vertices) v.y += 0.5;
  half.part.assign(half.panels.size(), 0);
  half.part[0] = 1;
  half.part_names = {"shell", "bow"};
  for (const bool has_wall : {true, false}) {
    Panels given = half;
    if (!has_wall) {
      for (std::size_t p = given.panels.size(); p-- > 0;) {
        bool in_plane = true;
        for (const int v : given.panels[p]) in_plane &= given.vertices[std::size_t(v)].y == 0;
        if (!in_plane) continue;
        given.panels.erase(given.panels.begin() + std::ptrdiff_t(p));
        given.part.erase(given.part.begin() + std::ptrdiff_t(p));
      }
    }
    const Surface ship(placed(given, {.mirror_merge = MirrorPlane::y}));
    CHECK(ship.is_closed());
    CHECK(ship.report().components == 1);
    CHECK(ship.report().volume == fixtures::relative(8, 1e-12));
    CHECK(ship.report().area == fixtures::relative(2 * (4 * 2 + 4 * 1 + 2 * 1), 1e-12));
    CHECK(ship.report().flipped == 0);
    REQUIRE(ship.report().parts.size() == 2);
    CHECK(ship.report().parts[0].panels + ship.report().parts[1].panels == 2 * given.panels.size());
  }
}
