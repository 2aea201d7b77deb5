#include "io/results/defect_files.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "fixtures/surfaces.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/vtp_file.hpp"

using namespace fccda;

TEST_CASE("defect files: each panel of each defect is written with its corners, number and kind, and nothing else") {
  const fixtures::TemporaryFolder folder;
  Panels panels = fixtures::unit_cube();  // six quads
  panels.vertices.push_back({9, 9, 9});   // of a panel that has no defect
  panels.add_triangle(0, 1, 8);
  panels.vertices.push_back({0.5, 0.25, 2});
  panels.add_triangle(0, 1, 9);
  const std::vector<Defect> defects{{DefectKind::self_intersection, {2, 7}}, {DefectKind::rim, {2}}};
  perimpact::write_defects(folder / "d.vtp", panels, defects);

  const fixtures::VtpFile file(fixtures::text_of(folder / "d.vtp"));
  CHECK(file.arrays.at("CellData/panel").as<std::int32_t>() == std::vector<std::int32_t>{2, 7, 2});
  CHECK(file.arrays.at("CellData/defect").as<std::int32_t>() == std::vector<std::int32_t>{4, 4, 0});
  const auto& points = file.arrays.at("Points/points");
  const auto connectivity = file.arrays.at("Polys/connectivity");
  const auto offsets = file.arrays.at("Polys/offsets").as<std::int32_t>();
  REQUIRE(offsets == std::vector<std::int32_t>{4, 7, 11});
  const auto corners = connectivity.as<std::int32_t>();
  const std::vector<int> numbers{2, 7, 2};
  const auto coordinates = points.as<double>();
  CHECK(coordinates.size() == 3 * 5);  // four corners of the quad, and the tip of the triangle on one of its edges
  std::size_t corner = 0;
  for (const int number : numbers)
    for (const int vertex : panels.panels[static_cast<std::size_t>(number)]) {
      if (vertex < 0) continue;
      const Vec3d& place = panels.vertices[static_cast<std::size_t>(vertex)];
      for (std::size_t axis = 0; axis < 3; ++axis) CHECK(coordinates[3 * static_cast<std::size_t>(corners[corner]) + axis] == place[axis]);
      ++corner;
    }
}

TEST_CASE("defect files: the guide lists the numbers of the kinds") {
  const std::string guide = fixtures::text_of(PROJECT_FOLDER "/docs/guide/surface_meshes.md");
  for (std::size_t kind = 0; kind < std::size(defect_names); ++kind)
    CHECK_MESSAGE(guide.find("| " + std::to_string(kind) + " | " + std::string(defect_names[kind]) + " |") != std::string::npos, defect_names[kind]);
}
