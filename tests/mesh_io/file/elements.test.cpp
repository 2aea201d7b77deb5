#include "mesh_io/file/elements.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/choose_parts.hpp"

using namespace fccda;

namespace {

using Edges = std::vector<std::array<int, 2>>;

struct Reference {
  ElementKind kind;
  std::vector<Vec3d> corners;
  Edges edges;  // those with a mid-side node, in its order
  std::size_t panels;
  double volume;  // 0: a surface
};

/// Unit elements with mid-side nodes at the midpoints, so that the quadratic ones have the same geometry.
std::vector<Reference> references() {
  const std::vector<Vec3d> hexahedron{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<Vec3d> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Vec3d> pyramid{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const std::vector<Vec3d> wedge{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const Edges of_tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  const Edges of_pyramid{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  const Edges of_wedge{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  const Edges of_hexahedron{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  using Kind = ElementKind;
  return {{Kind::tetrahedron, tetrahedron, {}, 4, 1.0 / 6},
          {Kind::tetrahedron_10, tetrahedron, of_tetrahedron, 16, 1.0 / 6},
          {Kind::pyramid, pyramid, {}, 5, 1.0 / 3},
          {Kind::pyramid_13, pyramid, of_pyramid, 21, 1.0 / 3},
          {Kind::wedge, wedge, {}, 5, 0.5},
          {Kind::wedge_15, wedge, of_wedge, 23, 0.5},
          {Kind::hexahedron, hexahedron, {}, 6, 1},
          {Kind::hexahedron_20, hexahedron, of_hexahedron, 30, 1}};
}

std::vector<int> counted(std::size_t n) {
  std::vector<int> out(n);
  std::iota(out.begin(), out.end(), 0);
  return out;
}

Elements one(const Reference& reference) {
  Elements out;
  out.vertices = reference.corners;
  for (const auto& [a, b] : reference.edges) out.vertices.push_back(0.5 * (reference.corners[std::size_t(a)] + reference.corners[std::size_t(b)]));
  out.add(reference.kind, counted(out.vertices.size()), out.part_number(""));
  return out;
}

int grid(int x, int y, int z) { return x + 4 * (y + 4 * z); }

/// 3 x 3 x 3 unit cubes; the lower layer is the part "ice", the others "steel".
Elements block() {
  Elements out;
  for (int v = 0; v < 64; ++v) out.vertices.push_back({double(v % 4), double(v / 4 % 4), double(v / 16)});
  for (int c = 0; c < 27; ++c) {
    const int x = c % 3, y = c / 3 % 3, z = c / 9;
    const std::array nodes{grid(x, y, z),     grid(x + 1, y, z),     grid(x + 1, y + 1, z),     grid(x, y + 1, z),
                           grid(x, y, z + 1), grid(x + 1, y, z + 1), grid(x + 1, y + 1, z + 1), grid(x, y + 1, z + 1)};
    out.add(ElementKind::hexahedron, nodes, out.part_number(z == 0 ? "ice" : "steel"));
  }
  return out;
}

}  // namespace

TEST_CASE("elements: the boundary faces of each solid, in either orientation, are closed, outward and enclose its volume") {
  for (const Reference& reference : references()) {
    CAPTURE(static_cast<int>(reference.kind));
    for (const bool mirrored : {false, true}) {
      Elements elements = one(reference);
      if (mirrored) std::for_each(elements.vertices.begin(), elements.vertices.end(), [](Vec3d& v) { v.x = -v.x; });
      const Panels skin = panels_of(elements, "file");
      CHECK(skin.panels.size() == reference.panels);
      const Surface surface(skin);
      CHECK(surface.is_closed());
      CHECK(surface.report().volume == fixtures::relative(reference.volume, 1e-12));
      CHECK(surface.report().rewound == 0);  // the boundary faces are consistent and outward,
      CHECK(surface.report().flipped == 0);  // so none is flipped
    }
  }
}

TEST_CASE("elements: faces follow mid-side nodes that bulge outward") {
  Reference ball{ElementKind::tetrahedron_10, {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}, 16, 0};
  Elements elements = one(ball);
  const double straight = Surface(panels_of(elements, "file")).report().volume;
  for (Vec3d& v : elements.vertices) v *= 1 / norm(v);  // mid-side nodes onto the sphere through the corners
  const double bulged = Surface(panels_of(elements, "file")).report().volume;
  // an octahedron over the mid-side nodes (4/3), and on four of its faces a pyramid up to the corner, of base √3/2 and height 1 - 1/√3
  CHECK(bulged == fixtures::relative(4.0 / 3 + 4 * std::sqrt(3.0) / 2 * (1 - 1 / std::sqrt(3.0)) / 3, 1e-12));
  CHECK(straight == fixtures::relative(8.0 / 3, 1e-12));
}

TEST_CASE("elements: only the outer faces of a block are boundary faces, and each part alone has its complete boundary") {
  const Panels whole = panels_of(block(), "file");
  CHECK(whole.panels.size() == 54);
  CHECK(Surface(whole).report().volume == fixtures::relative(27, 1e-12));
  REQUIRE(whole.part_names == std::vector<std::string>{"ice", "steel"});
  CHECK(std::count(whole.part.begin(), whole.part.end(), 0) == 9 + 12);

  Elements ice = block();
  keep_parts(ice, std::vector<std::string>{"ice"}, "file");
  const Surface alone(panels_of(ice, "file"));
  CHECK(alone.is_closed());
  CHECK(alone.report().volume == fixtures::relative(9, 1e-12));
  CHECK(alone.report().area == fixtures::relative(2 * 9 + 4 * 3, 1e-12));
}

TEST_CASE("elements: a surface element replaces the boundary face it covers, and one between two solids is internal") {
  Elements elements = block();
  const int hull = elements.part_number("hull");
  elements.add(ElementKind::polygon, std::vector{grid(0, 0, 3), grid(1, 0, 3), grid(1, 1, 3), grid(0, 1, 3)}, hull);
  elements.add(ElementKind::polygon, std::vector{grid(0, 0, 1), grid(1, 0, 1), grid(1, 1, 1), grid(0, 1, 1)}, hull);
  const Panels panels = panels_of(elements, "file");
  CHECK(panels.panels.size() == 54);
  CHECK(Surface(panels).report().duplicate == 0);
  REQUIRE(panels.part_names.size() == 3);
  CHECK(std::count(panels.part.begin(), panels.part.end(), 2) == 1);
}

TEST_CASE("elements: quadratic surface elements become panels over their mid-side nodes") {
  Elements elements;
  elements.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 1, 0}};
  elements.add(ElementKind::quad_9, counted(9), elements.part_number(""));
  CHECK(panels_of(elements, "file").panels.size() == 4);
  CHECK(Surface(panels_of(elements, "file"), {.orientation = Orientation::normals}).report().area == fixtures::relative(4, 1e-12));
  elements.kinds[0] = ElementKind::quad_8;
  elements.nodes.pop_back();
  elements.ends[0] = 8;
  CHECK(panels_of(elements, "file").panels.size() == 5);
  CHECK(Surface(panels_of(elements, "file"), {.orientation = Orientation::normals}).report().area == fixtures::relative(4, 1e-12));
}

TEST_CASE("elements: three solids on one face and polygons that cannot be triangulated are refused") {
  Elements elements = one(references()[0]);
  elements.add(ElementKind::tetrahedron, counted(4), 0);
  elements.add(ElementKind::tetrahedron, counted(4), 0);
  CHECK_THROWS_WITH_AS(panels_of(elements, "mesh.inp"),
                       "mesh.inp: 3 solid elements share one face, the first of them element 1 in file order; elements must not overlap, so repair the mesh.",
                       InputError);
  Elements polygon;
  polygon.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 5, 0}};
  polygon.add(ElementKind::polygon, counted(5), polygon.part_number(""));
  CHECK_THROWS_WITH_AS(
      panels_of(polygon, "mesh.vtk"),
      "mesh.vtk: element 1 in file order, a polygon with 5 corners, cannot be triangulated because its sides cross; triangulate the mesh before exporting it.",
      InputError);
}

TEST_CASE("parts: an unknown name is refused with the closest match or the list of parts") {
  Elements elements = block();
  CHECK_THROWS_WITH_AS(keep_parts(elements, std::vector<std::string>{"steal"}, "m.inp"),
                       "m.inp: the surface has no part \"steal\"; did you mean steel? Its parts are ice, steel.", InputError);
  CHECK_THROWS_WITH_AS(keep_parts(elements, std::vector<std::string>{"hull"}, "m.inp"), "m.inp: the surface has no part \"hull\"; its parts are ice, steel.",
                       InputError);
  Panels nameless = panels_of(one(references()[0]), "m.stl");
  CHECK_THROWS_WITH_AS(keep_parts(nameless, std::vector<std::string>{"hull"}, "m.stl"),
                       "m.stl: the surface has no part \"hull\"; its panels have no names, so omit the parts, or name them in its file.", InputError);
}

TEST_CASE("parts: panels of other parts are removed, and the rest keep their names") {
  Panels panels = panels_of(block(), "file");
  const Panels before = panels;
  keep_parts(panels, std::vector<std::string>{"steel"}, "file");
  CHECK(panels.part_names == std::vector<std::string>{"steel"});
  CHECK(panels.panels.size() == 54 - 21);
  CHECK(std::all_of(panels.part.begin(), panels.part.end(), [](int part) { return part == 0; }));
  std::vector<std::array<int, 4>> expected;
  for (std::size_t p = 0; p < before.panels.size(); ++p)
    if (before.part[p] == 1) expected.push_back(before.panels[p]);
  CHECK(panels.panels == expected);
}
