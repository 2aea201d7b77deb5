#include "mesh_io/keyword/repeated_nodes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

using Ids = std::vector<std::int64_t>;

/// Corners of the unit cube by node number, 0123 below 4567.
const std::vector<Vec3d> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

double volume(const NumberedShape& shape) {
  Elements elements;
  elements.vertices = corners;
  const std::vector<int> nodes(shape.all().begin(), shape.all().end());
  elements.add(shape.kind, nodes, elements.part_number(""));
  const Surface surface(panels_of(elements, "file"));
  CHECK(surface.is_closed());
  return surface.report().volume;
}

}  // namespace

TEST_CASE("repeats: hexahedra with repeated nodes reduce to the solids that solvers write so") {
  struct Case {
    Ids nodes;
    ElementKind kind;
    double volume;  // [-] fraction of the unit cube
  };
  const Case cases[] = {{{0, 1, 2, 3, 4, 5, 6, 7}, ElementKind::hexahedron, 1},
                        {{0, 1, 2, 3, 4, 4, 7, 7}, ElementKind::wedge, 0.5},  // LS-DYNA: a quad, and an edge over it
                        {{0, 1, 2, 2, 4, 5, 6, 6}, ElementKind::wedge, 0.5},  // a triangle over a triangle
                        {{0, 0, 2, 3, 4, 4, 6, 7}, ElementKind::wedge, 0.5},
                        {{0, 1, 2, 3, 4, 4, 4, 4}, ElementKind::pyramid, 1.0 / 3},
                        {{0, 1, 2, 2, 4, 4, 4, 4}, ElementKind::tetrahedron, 1.0 / 6},
                        {{0, 1, 2, 4, 4, 4, 4, 4}, ElementKind::tetrahedron, 1.0 / 6} /* LS-DYNA */};
  for (const Case& one : cases) {
    const auto shape = solid_without_repeats(one.nodes);
    REQUIRE(shape);
    CHECK(shape->kind == one.kind);
    CHECK(volume(*shape) == fixtures::relative(one.volume, 1e-12));
  }
}

TEST_CASE("repeats: wedges, pyramids and tetrahedra may also repeat nodes") {
  CHECK(solid_without_repeats(Ids{0, 1, 2, 4, 5, 6})->kind == ElementKind::wedge);
  CHECK(solid_without_repeats(Ids{0, 1, 2, 4, 4, 4})->kind == ElementKind::tetrahedron);
  CHECK(solid_without_repeats(Ids{0, 1, 2, 0, 5, 6})->kind == ElementKind::pyramid);
  CHECK(solid_without_repeats(Ids{0, 1, 2, 3, 4})->kind == ElementKind::pyramid);
  CHECK(solid_without_repeats(Ids{0, 1, 2, 2, 4})->kind == ElementKind::tetrahedron);
  CHECK(solid_without_repeats(Ids{0, 1, 2, 4})->kind == ElementKind::tetrahedron);
}

TEST_CASE("repeats: flat and folded elements and those of seven nodes are refused") {
  for (const Ids& nodes : {Ids{0, 1, 2, 3, 0, 1, 2, 3}, Ids{0, 0, 0, 0, 0, 0, 0, 0}, Ids{0, 1, 2, 3, 4, 4, 6, 7}, Ids{0, 1, 0, 1, 4, 5, 6, 7},
                           Ids{0, 1, 2, 4, 4, 6}, Ids{0, 1, 2, 2}, Ids{1, 1, 1, 1}}) {
    CHECK_FALSE(solid_without_repeats(nodes));
  }
}

TEST_CASE("repeats: whatever nodes a hexahedron repeats, the result is a closed solid of distinct nodes") {
  std::mt19937_64 random(1);
  int found = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Ids nodes(8);
    for (auto& node : nodes) node = static_cast<std::int64_t>(random() % 8);
    const auto shape = solid_without_repeats(nodes);
    if (!shape) continue;
    ++found;
    Ids left(shape->all().begin(), shape->all().end());
    CHECK(left.size() == nodes_of(shape->kind));
    std::sort(left.begin(), left.end());
    CHECK(std::adjacent_find(left.begin(), left.end()) == left.end());
  }
  CHECK(found > 100);
}

TEST_CASE("repeats: a quad with a repeated corner is a triangle, and with fewer than three corners nothing") {
  CHECK(surface_without_repeats(Ids{0, 1, 2, 3})->count == 4);
  for (const Ids& nodes : {Ids{0, 1, 2, 2}, Ids{0, 0, 1, 2}, Ids{0, 1, 1, 2}, Ids{0, 1, 2, 0}, Ids{0, 1, 2}}) CHECK(surface_without_repeats(nodes)->count == 3);
  for (const Ids& nodes : {Ids{0, 1, 0, 2}, Ids{0, 1, 1, 0}, Ids{0, 1, 1}, Ids{0, 0, 0, 0}}) CHECK_FALSE(surface_without_repeats(nodes));
}
