#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "fccda/c/scenes.hpp"
#include "fixtures/temporary_folder.hpp"
#include "marine/hull.hpp"
#include "marine/propeller.hpp"

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

TEST_CASE("C interface: hulls and propellers are those of C++, and a member that is 0 has its default") {
  const auto panels_of = [](const fccda_surface* surface) {
    fccda_surface_info info{};
    CHECK(fccda_surface_measure(surface, &info) == FCCDA_OK);
    Panels panels;
    panels.vertices.resize(static_cast<std::size_t>(info.panel_vertices)), panels.panels.resize(static_cast<std::size_t>(info.panels));
    const fccda_vectors into = fccda_xyz(&panels.vertices[0].x, panels.vertices.size());
    CHECK(fccda_surface_vertices(surface, &into) == FCCDA_OK);
    CHECK(fccda_surface_panels(surface, panels.panels[0].data(), panels.panels.size()) == FCCDA_OK);
    return panels;
  };
  const auto expect_same = [&](fccda_surface* surface, const Panels& expected) {
    const Panels found = panels_of(surface);
    CHECK(found.vertices == expected.vertices);
    CHECK(found.panels == expected.panels);
    fccda_surface_destroy(surface);
  };
  fccda_hull hull{120, 20, 6, 3, 0.5, 0.4, 0, 0, 0, 1.5, 0.7, 0.1, 4, 2};
  HullShape shape{.length = 120, .breadth = 20, .draft = 6, .freeboard = 3, .stem_angle = 0.5, .waterline_angle = 0.4, .bilge_radius = 1.5, .stem_radius = 0.7};
  shape.flare = 0.1, shape.edge_length = 4, shape.bow_edge_length = 2;
  fccda_surface* surface = nullptr;
  REQUIRE(fccda_surface_hull(&hull, &surface) == FCCDA_OK);
  expect_same(surface, make_hull(shape));
  hull.fullness = shape.fullness = 1.5, hull.stern_angle = shape.stern_angle = 0.7, hull.stern_waterline_angle = shape.stern_waterline_angle = 0.6;
  REQUIRE(fccda_surface_hull(&hull, &surface) == FCCDA_OK);
  expect_same(surface, make_hull(shape));

  fccda_propeller propeller{3, 0.9, 0.6, 0.3, 0.8, 0.1, 0.05, 0, 0, 0.2, 0.1, 5, 2, 1, 0};
  PropellerShape blades{.blades = 5, .diameter = 3, .pitch_ratio = 0.9, .area_ratio = 0.6, .hub_ratio = 0.3, .hub_length = 0.8, .rake = 0.1, .skew = 0.05};
  blades.hand = Hand::left, blades.axis = Axis::z, blades.edge_length = 0.2, blades.blade_edge_length = 0.1;
  REQUIRE(fccda_surface_propeller(&propeller, &surface) == FCCDA_OK);
  expect_same(surface, make_propeller(blades));
  propeller.thickness_factor = blades.thickness_factor = 1.2, propeller.edge_thickness = blades.edge_thickness = 0.2;
  REQUIRE(fccda_surface_propeller(&propeller, &surface) == FCCDA_OK);
  expect_same(surface, make_propeller(blades));
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
