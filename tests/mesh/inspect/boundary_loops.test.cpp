#include "mesh/inspect/boundary_loops.hpp"

#include <doctest/doctest.h>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;

TEST_CASE("boundary loops: each hole is one, the longest first, with its length and position") {
  Panels box = make_box({.size = {4, 4, 4}, .edge_length = 1, .panels = PanelKind::quads});
  const auto middle = [&](const std::array<int, 4>& p) {
    Vec3d sum{};
    for (const int v : p) sum += 0.25 * box.vertices[std::size_t(v)];
    return sum;
  };
  // a hole of one panel in the top, and one of two panels in a side
  std::erase_if(box.panels, [&](const auto& p) { return norm(middle(p) - Vec3d{0.5, 0.5, 2}) < 0.1; });
  std::erase_if(box.panels, [&](const auto& p) { return norm(middle(p) - Vec3d{2, 0.5, 0.5}) < 0.1 || norm(middle(p) - Vec3d{2, 0.5, -0.5}) < 0.1; });
  const std::vector<BoundaryLoop> found = boundary_loops(Surface(box, {.orientation = Orientation::normals}));
  REQUIRE(found.size() == 2);
  CHECK(found[0].edges == 6);
  CHECK(found[0].length == fixtures::relative(6, 1e-12));
  CHECK(found[0].bounds.low == Vec3d{2, 0, -1});
  CHECK(found[0].bounds.high == Vec3d{2, 1, 1});
  CHECK(found[1].edges == 4);
  CHECK(found[1].length == fixtures::relative(4, 1e-12));
  CHECK(found[1].bounds.centre() == Vec3d{0.5, 0.5, 2});
}

TEST_CASE("boundary loops: a closed surface has none, a band has two") {
  CHECK(boundary_loops(Surface(make_sphere({.diameter = 1, .edge_length = 0.2}))).empty());
  CHECK(boundary_loops(Surface(fixtures::band(40, 0), {.orientation = Orientation::normals})).size() == 2);
}
