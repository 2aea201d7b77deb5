#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "fccda/c/scenes.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace c_scenes;

TEST_CASE("C interface: surfaces from files, arrays and sizes are measured, and give back their panels") {
  const fixtures::TemporaryFolder folder;
  const std::string path = (folder.path() / "open.obj").string();
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 1 0\nf 1 2 3\nf 2 5 3\nf 4 2 3\n";
  const fccda_surface_options upward{0, nullptr, FCCDA_NORMALS, 0};
  fccda_surface* surface = nullptr;
  REQUIRE(fccda_surface_read(path.c_str(), &upward, &surface) == FCCDA_OK);
  fccda_surface_info info{};
  CHECK(fccda_surface_measure(surface, &info) == FCCDA_OK);
  CHECK(info.panels == 3);
  CHECK(info.triangles == 2);
  CHECK(info.panel_vertices == 5);
  CHECK(info.vertices == 4);
  CHECK(info.repairs == 2);  // a vertex merged, a panel dropped
  CHECK(info.is_closed == 0);
  CHECK(info.area == 1.0);
  CHECK(as_vector(info.high) == Vec3d{1, 1, 0});
  CHECK(std::string(fccda_surface_report(surface)) ==
        "3 panels, 2 triangles, 4 vertices, 1 components, open\nrepaired: 1 coincident vertices merged\nrepaired: 1 duplicate panels removed\n");
  std::vector<double> vertices(15);
  const fccda_vectors into = fccda_xyz(vertices.data(), 5);
  std::vector<std::int32_t> panels(12);
  CHECK(fccda_surface_vertices(surface, &into) == FCCDA_OK);
  CHECK(fccda_surface_panels(surface, panels.data(), 3) == FCCDA_OK);
  CHECK(vertices == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0});
  CHECK(panels == std::vector<std::int32_t>{0, 1, 2, -1, 1, 4, 2, -1, 3, 1, 2, -1});
  fccda_surface_destroy(surface);

  const double size[] = {1, 2, 3};
  REQUIRE(fccda_surface_box(size, 0, &surface) == FCCDA_OK);
  CHECK(fccda_surface_measure(surface, &info) == FCCDA_OK);
  CHECK(info.volume == 6.0);
  CHECK(info.area == 22.0);
  CHECK(info.is_closed == 1);
  CHECK(as_vector(info.low) == Vec3d{-0.5, -1, -1.5});
  CHECK(as_vector(info.centroid) == Vec3d{});
  CHECK(info.repairs == 0);
  fccda_surface_destroy(surface);
  REQUIRE(fccda_surface_cylinder(2, 5, 1, 0.5, &surface) == FCCDA_OK);
  CHECK(fccda_surface_measure(surface, &info) == FCCDA_OK);
  CHECK(info.high[1] == 2.5);
  fccda_surface_destroy(surface);
  REQUIRE(fccda_surface_sphere(2, 0, &surface) == FCCDA_OK);
  fccda_surface_destroy(surface);
}

TEST_CASE("C interface: header and library have one version of the binary interface, and helpers describe the arrays that they are given") {
  CHECK(fccda_abi_version() == FCCDA_ABI_VERSION);
  CHECK(FCCDA_ABI_VERSION == 1);
  CHECK(std::string(fccda_version()).find('.') != std::string::npos);
  double xyz[6], numbers[2];
  float single[6];
  const fccda_vectors rows = fccda_xyz(xyz, 2), floats = fccda_xyz_float(single, 2), three = fccda_three(xyz, xyz + 2, xyz + 4, 2),
                      three_floats = fccda_three_float(single, single + 2, single + 4, 2);
  CHECK((rows.x == xyz && rows.y == xyz + 1 && rows.z == xyz + 2 && rows.count == 2 && rows.stride == 24 && rows.type == FCCDA_DOUBLE));
  CHECK((floats.y == single + 1 && floats.z == single + 2 && floats.stride == 12 && floats.type == FCCDA_FLOAT));
  CHECK((three.x == xyz && three.y == xyz + 2 && three.z == xyz + 4 && three.stride == 8 && three.type == FCCDA_DOUBLE));
  CHECK((three_floats.y == single + 2 && three_floats.stride == 4 && three_floats.type == FCCDA_FLOAT));
  CHECK((fccda_each(numbers, 2).first == numbers && fccda_each(numbers, 2).stride == 8 && fccda_each(numbers, 2).type == FCCDA_DOUBLE));
  CHECK((fccda_each_float(single, 6).count == 6 && fccda_each_float(single, 6).stride == 4 && fccda_each_float(single, 6).type == FCCDA_FLOAT));
  CHECK((fccda_one(2).value == 2 && fccda_one(2).type == FCCDA_ONE && fccda_unset().type == FCCDA_UNSET));
}
