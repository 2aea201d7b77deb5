// Point clouds: cells of meshes in all formats with cells, and points of a list.
#include "perimpact/discretisation/cloud_of.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "fixtures/gmsh_files.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/space_order.hpp"

using namespace perimpact;
using fccda::ElementKind;

namespace {

fixtures::GmshMesh gmsh_block(ElementKind kind, int n) {
  const fccda::Elements block = fixtures::block_of(kind, n);
  const int type = kind == ElementKind::hexahedron ? 5 : kind == ElementKind::wedge ? 6 : 4;
  fixtures::GmshMesh mesh;
  mesh.vertices = block.vertices;
  mesh.elements.push_back({2, {0, 1, n + 1}});  // a triangle of the skin, as Gmsh leaves them in
  for (std::size_t e = 0; e < block.size(); ++e) {
    const auto nodes = block.nodes_of_element(e);
    mesh.elements.push_back({type, {nodes.begin(), nodes.end()}});
  }
  return mesh;
}

BodySetup body_of(BodyShape shape) {
  BodySetup body;
  body.name = "ice", body.shape = std::move(shape);
  return body;
}

CellsShape cells(const std::filesystem::path& file) {
  CellsShape shape;
  shape.file = file.string();
  return shape;
}

std::string complaint(const BodySetup& body, std::string* key = nullptr) {
  try {
    cloud_of(body);
  } catch (const SetupError& error) {
    if (key) *key = error.key();
    return error.what();
  }
  return "";
}

PointsShape grid() {
  PointsShape shape;
  shape.file = "grid.csv";
  for (int k = 0; k < 64; ++k) {
    shape.points.push_back({k % 4 * 0.5, k / 4 % 4 * 0.5, k / 16 * 0.5});
    shape.volumes.push_back(0.125 + 0.001 * k);
  }
  return shape;
}

}  // namespace

TEST_CASE("cloud: each solid cell of a mesh becomes a particle at its centroid with its volume, in Gmsh, Abaqus and LS-DYNA files alike") {
  const fixtures::TemporaryFolder folder;
  for (const ElementKind kind : {ElementKind::hexahedron, ElementKind::wedge, ElementKind::tetrahedron}) {
    const int n = 3, cuts = kind == ElementKind::hexahedron ? 1 : kind == ElementKind::wedge ? 2 : 6;
    fixtures::put(folder / "block.msh", fixtures::gmsh_file(gmsh_block(kind, n)));
    fixtures::put(folder / "block.inp", fixtures::abaqus_text(fixtures::block_of(kind, n)));
    for (const char* name : {"block.msh", "block.inp"}) {
      CellsShape shape = cells(folder / name);
      shape.scale = 0.5;
      const Cloud found = cloud_of(body_of(shape));
      REQUIRE(found.points.size() == std::size_t(n * n * n * cuts));
      CHECK(std::set<std::uint32_t>(found.numbers.begin(), found.numbers.end()).size() == found.numbers.size());
      for (const double volume : found.volumes) CHECK(volume == fixtures::relative(0.125 / cuts, 1e-12));
      Vec3d centre{};
      for (const Vec3d& point : found.points) centre += point / double(found.points.size());
      CHECK(norm(centre - Vec3d{0.75, 0.75, 0.75}) < 1e-12);  // rounding
      if (kind == ElementKind::hexahedron)
        for (std::size_t k = 0; k < found.numbers.size(); ++k) {
          const int c = int(found.numbers[k]);
          CHECK(norm(found.points[k] - 0.5 * Vec3d{c % n + 0.5, c / n % n + 0.5, c / (n * n) + 0.5}) < 1e-12);
        }
    }
  }
}

TEST_CASE("cloud: parts of a mesh can be selected, and holes remove cells") {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "block.inp", fixtures::abaqus_text(fixtures::block_of(ElementKind::hexahedron, 3)));
  CellsShape shape = cells(folder / "block.inp");
  shape.file_parts = {"ice"};
  BodySetup body = body_of(shape);
  CHECK(cloud_of(body).points.size() == 9);
  body.position = {0, 0, 7};
  body.holes = {{"drain", BoxSolid{{1, 1, 1}}, {0.5, 0.5, 0.5}, {}}};
  const Cloud with_hole = cloud_of(body);
  CHECK(with_hole.points.size() == 8);
  CHECK(std::find(with_hole.numbers.begin(), with_hole.numbers.end(), 0u) == with_hole.numbers.end());
  for (const Vec3d& point : with_hole.points) CHECK(point.z == fixtures::relative(7.5, 1e-12));
  std::string key;
  body.holes[0].shape = SphereSolid{100};
  CHECK(complaint(body, &key) == "the holes of body ice remove all of its particles; make them smaller, or move them.");
  CHECK(key == "bodies.ice.holes");
}

TEST_CASE("cloud: triangles and quads of a plane mesh, with a thickness") {
  const fixtures::TemporaryFolder folder;
  fixtures::GmshMesh mesh;
  mesh.vertices = {{0, 0, 0.5}, {2, 0, 0.5}, {2, 1, 0.5}, {0, 1, 0.5}, {3, 0, 0.5}};
  mesh.elements = {{1, {0, 1}}, {3, {0, 1, 2, 3}}, {2, {1, 4, 2}}};
  fixtures::put(folder / "plate.msh", fixtures::gmsh_file(mesh));
  CellsShape shape = cells(folder / "plate.msh");
  shape.thickness = 0.1;
  const Cloud found = cloud_of(body_of(shape));
  REQUIRE(found.numbers == std::vector<std::uint32_t>{0, 1});
  CHECK(found.thickness == 0.1);
  CHECK(found.volumes[0] == fixtures::relative(0.2, 1e-14));
  CHECK(found.volumes[1] == fixtures::relative(0.05, 1e-14));
  CHECK(norm(found.points[0] - Vec3d{1, 0.5, 0.5}) < 1e-14);
  CHECK(norm(found.points[1] - Vec3d{7.0 / 3, 1.0 / 3, 0.5}) < 1e-14);

  mesh.vertices[4].z = 0.6;
  fixtures::put(folder / "plate.msh", fixtures::gmsh_file(mesh));
  CHECK(complaint(body_of(shape)) == shape.file +
                                         ": element 2 in the order of the file extends from z = 0.5 m to 0.6 m, but the mesh of a plane body has a single z; "
                                         "rotate it into the x-y plane, or omit thickness.");
}

TEST_CASE("cloud: points keep volumes and numbers, in a space-filling order, in the body's position") {
  BodySetup body = body_of(grid());
  body.position = {10, 0, 0}, body.rotate = {0, 0, std::acos(-1.0) / 2};
  const Cloud found = cloud_of(body);
  REQUIRE(found.numbers.size() == 64);
  for (std::size_t k = 0; k < 64; ++k) {
    const Vec3d given = grid().points[found.numbers[k]];
    CHECK(norm(found.points[k] - Vec3d{10 - given.y, given.x, given.z}) < 1e-14);
    CHECK(found.volumes[k] == grid().volumes[found.numbers[k]]);
  }
  // the first eighth of the curve is one corner: two points along each axis
  for (std::size_t k = 0; k < 8; ++k) CHECK(fccda::largest_magnitude(grid().points[found.numbers[k]]) <= 0.5);
}

TEST_CASE("cloud: coincident particles are refused, with their numbers") {
  PointsShape shape = grid();
  shape.points[40] = shape.points[7];
  std::string key;
  CHECK(complaint(body_of(shape), &key) == "grid.csv: particles 8 and 41 in the order of the file coincide at (1.5, 0.5, 0) m; remove one.");
  CHECK(key == "bodies.ice.shape.points.file");
}

TEST_CASE("cloud: points of a plane body share one z") {
  PointsShape shape = grid();
  shape.thickness = 0.1;
  CHECK(complaint(body_of(shape)) ==
        "grid.csv: row 17 has another z than the first, 0.5 m and 0 m, but all particles of a plane body share one z; use the same z in all rows, or omit "
        "thickness.");
}

TEST_CASE("cloud: meshes without solid cells, broken cells and files without cells are refused with the file and the element") {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "skin.msh", fixtures::gmsh_file(fixtures::gmsh_mesh(fixtures::unit_cube())));
  CHECK(complaint(body_of(cells(folder / "skin.msh"))) ==
        (folder / "skin.msh").string() +
            ": the file has no solid cells, only a surface; mesh the volume, or fill the surface with shape: {file: …}, or give a thickness for a plane body.");
  fixtures::GmshMesh mesh = gmsh_block(ElementKind::hexahedron, 2);
  std::swap(mesh.elements[3].nodes[2], mesh.elements[3].nodes[3]);
  fixtures::put(folder / "tangled.msh", fixtures::gmsh_file(mesh));
  CHECK(complaint(body_of(cells(folder / "tangled.msh"))) ==
        (folder / "tangled.msh").string() + ": element 4 in the order of the file, about (0, 1, 0) m, has no volume or is inverted; repair the mesh.");
  CellsShape plane = cells(folder / "tangled.msh");
  plane.thickness = 1;
  CHECK(complaint(body_of(plane)).find("element 2 in the order of the file is a solid, but a plane body consists of triangles and quads;") !=
        std::string::npos);
  CHECK(complaint(body_of(cells(folder / "cube.stl"))) ==
        (folder / "cube.stl").string() + ": this format has no cells; the mesh formats are .vtk, .vtp, .vtu, .msh, .inp, .k, .key, .dyn.");
}

TEST_CASE("cloud: the space-filling order contains all points, and is stable for coincident points") {
  const std::vector<Vec3d> points{{1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0, 0, 0.1}, {0.9, 0, 0}};
  CHECK(space_order(points) == std::vector<std::uint32_t>{1, 3, 4, 0, 2});
  CHECK(space_order(std::vector<Vec3d>{{3, 3, 3}}) == std::vector<std::uint32_t>{0});
}
