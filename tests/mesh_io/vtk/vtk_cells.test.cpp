#include "mesh_io/vtk/vtk_cells.hpp"

#include <doctest/doctest.h>

#include <array>
#include <numeric>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

/// One cell over the given points, in order.
Elements one(std::int64_t type, const std::vector<Vec3d>& points) {
  VtkElements out("mesh.vtu");
  std::vector<double> coordinates;
  for (const Vec3d& v : points) coordinates.insert(coordinates.end(), {v.x, v.y, v.z});
  out.begin_piece(coordinates);
  VtkCells cell;
  cell.points.resize(points.size());
  std::iota(cell.points.begin(), cell.points.end(), 0);
  cell.ends = {static_cast<std::int64_t>(points.size())};
  out.add(cell, std::span(&type, 1), {});
  return out.take();
}

struct Body {
  std::int64_t type;
  std::vector<Vec3d> corners;
  std::vector<std::vector<int>> middles;  ///< of edges, faces and the cell: the corners between which they lie
  double volume;
};

std::vector<Vec3d> points_of(const Body& body) {
  std::vector<Vec3d> points = body.corners;
  for (const std::vector<int>& middle : body.middles) {
    Vec3d sum{};
    for (const int corner : middle) sum += body.corners[static_cast<std::size_t>(corner)];
    points.push_back(sum / static_cast<double>(middle.size()));
  }
  return points;
}

using Middles = std::vector<std::vector<int>>;
Middles joined(Middles a, const Middles& b) { return a.insert(a.end(), b.begin(), b.end()), a; }

/// Unit solids with the points of the VTK documentation (vtkTriQuadraticHexahedron and so on), in its order.
std::vector<Body> bodies() {
  const std::vector<Vec3d> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<Vec3d> voxel{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const std::vector<Vec3d> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Vec3d> wedge{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}};
  const std::vector<Vec3d> pyramid{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const Middles of_cube{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const Middles of_tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  const Middles of_wedge{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  const Middles of_pyramid{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  const Middles sides{{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}}, ends{{0, 1, 2, 3}, {4, 5, 6, 7}}, all{{0, 1, 2, 3, 4, 5, 6, 7}};
  const Middles sides_of_wedge{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  const Middles faces_of_pyramid{{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 1, 2, 3, 4}};
  return {{10, tetrahedron, {}, 1.0 / 6},
          {11, voxel, {}, 1},
          {12, cube, {}, 1},
          {13, wedge, {}, 0.5},
          {14, pyramid, {}, 1.0 / 3},
          {24, tetrahedron, of_tetrahedron, 1.0 / 6},
          {25, cube, of_cube, 1},
          {26, wedge, of_wedge, 0.5},
          {27, pyramid, of_pyramid, 1.0 / 3},
          {29, cube, joined(joined(of_cube, sides), joined(ends, all)), 1},
          {32, wedge, joined(of_wedge, sides_of_wedge), 0.5},
          {33, cube, joined(of_cube, sides), 1},
          {37, pyramid, joined(of_pyramid, faces_of_pyramid), 1.0 / 3}};
}

std::vector<Body> faces() {
  const std::vector<Vec3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Middles of_square{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, of_triangle{{0, 1}, {1, 2}, {2, 0}};
  return {{5, triangle, {}, 0.5},
          {7, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1.5, 0}, {0, 1, 0}}, {}, 1.25},
          {8, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}, 1},
          {9, square, {}, 1},
          {22, triangle, of_triangle, 0.5},
          {23, square, of_square, 1},
          {28, square, joined(of_square, {{0, 1, 2, 3}}), 1},
          {34, triangle, joined(of_triangle, {{0, 1, 2}}), 0.5}};
}

}  // namespace

TEST_CASE("vtk cells: the boundary faces of each kind of solid are closed and enclose its volume") {
  for (const Body& body : bodies()) {
    CAPTURE(body.type);
    const Surface surface(panels_of(one(body.type, points_of(body)), "mesh.vtu"));
    CHECK(surface.is_closed());
    CHECK(surface.report().volume == fixtures::relative(body.volume, 1e-12));
  }
}

TEST_CASE("vtk cells: each kind of face has its area and the normal of its winding") {
  for (const Body& face : faces()) {
    CAPTURE(face.type);
    const Surface surface(panels_of(one(face.type, points_of(face)), "mesh.vtu"), {.orientation = Orientation::normals});
    CHECK(surface.report().area == fixtures::relative(face.volume, 1e-12));
    CHECK(surface.report().degenerate == 0);
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) CHECK(surface.normal(t).z == fixtures::relative(1, 1e-12));
  }
}

TEST_CASE("vtk cells: the triangles of a strip all have the orientation of the first") {
  const Panels panels = panels_of(one(6, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}}), "mesh.vtu");
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {2, 1, 3, -1}, {2, 3, 4, -1}, {4, 3, 5, -1}});
  CHECK(Surface(panels, {.orientation = Orientation::normals}).report().rewound == 0);
}

TEST_CASE("vtk cells: points and lines of any kind are skipped") {
  for (const std::int64_t type : {0, 1, 2, 3, 4, 21, 35, 68, 75}) CHECK(one(type, {{0, 0, 0}, {1, 0, 0}}).size() == 0);
}

TEST_CASE("vtk cells: unsupported kinds are refused by name") {
  const char* sentences[] = {"a pentagonal prism",      "a polyhedron",           "a Lagrange tetrahedron", "a Bézier triangle",
                             "a cell of VTK's type 60", "a cell of VTK's type -1"};
  const std::int64_t types[] = {15, 42, 71, 76, 60, -1};
  for (std::size_t k = 0; k < std::size(types); ++k) {
    const std::string sentence = std::string("mesh.vtu: cell 0 (counted from 0) is ") + sentences[k] +
                                 ", which is not supported; export linear or quadratic cells, for example with the ParaView filter Extract Surface.";
    CHECK_THROWS_WITH_AS(one(types[k], {{0, 0, 0}}), sentence.c_str(), InputError);
  }
}

TEST_CASE("vtk cells: too few points, undefined points and offsets out of order are refused with the cell and the piece") {
  CHECK_THROWS_WITH_AS(one(12, {{0, 0, 0}}), "mesh.vtu: cell 0 (counted from 0) has 1 points, but needs 8; correct the file or export it again.", InputError);
  CHECK_THROWS_WITH_AS(one(7, {{0, 0, 0}}), "mesh.vtu: cell 0 (counted from 0) has 1 points, but needs 3; correct the file or export it again.", InputError);
  const std::vector<double> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int64_t type = 5;
  const auto add = [&](const VtkCells& cells) {
    VtkElements out("mesh.vtu");
    out.begin_piece({});
    out.begin_piece(triangle);
    out.add(cells, std::span(&type, 1), {});
  };
  CHECK_THROWS_WITH_AS(add({{0, 1, 2, 0, 1, 3}, {3, 6}}),
                       "mesh.vtu: piece 2: cell 1 (counted from 0) has point 3, but there are 3, counted from 0; correct the file or export it again.",
                       InputError);
  CHECK_THROWS_WITH_AS(add({{0, 1, -1}, {3}}),
                       "mesh.vtu: piece 2: cell 0 (counted from 0) has point -1, but there are 3, counted from 0; correct the file or export it again.",
                       InputError);
  for (const std::int64_t end : {2, -1, 7}) {
    CHECK_THROWS_WITH_AS(add({{0, 1, 2, 0, 1, 2}, {3, end}}),
                         "mesh.vtu: piece 2: cell 1 (counted from 0) has an offset that is out of order; correct the file or export it again.", InputError);
  }
  CHECK_THROWS_WITH_AS(add({{0, 1, 2, 0}, {3}}), "mesh.vtu: the cells have 3 point numbers, but the file has 4; correct the file or export it again.",
                       InputError);
}

TEST_CASE("vtk cells: parts are named by number, and cells of pieces without part numbers belong to no part") {
  VtkElements out("mesh.vtu");
  const std::vector<double> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int64_t type = 5;
  const VtkCells cells{{0, 1, 2, 1, 2, 0, 2, 0, 1}, {3, 6, 9}};
  const std::int64_t parts[] = {3, -1, 3};
  out.begin_piece(triangle);
  out.add(cells, std::span(&type, 1), parts);
  out.begin_piece(triangle);
  out.add(cells, std::span(&type, 1), {});
  const Elements elements = out.take();
  CHECK(elements.part_names == std::vector<std::string>{"part 3", "part -1", ""});
  CHECK(elements.part == std::vector{0, 1, 0, 2, 2, 2});
  CHECK(elements.nodes_of_element(3)[0] == 3);  // the second piece numbers its points from 0
}

TEST_CASE("vtk cells: of several part arrays the one of best rank is used") {
  int rank = 0;
  for (const char* array : {"part", "PartId", "gmsh:physical", "gmsh:geometrical", "medit:ref", "CellEntityIds", "STLSolidLabeling"})
    CHECK(vtk_part_rank(array) == rank++);
  CHECK(vtk_part_rank("pressure") == -1);
}
