// What a deck may say about solids, clouds, cracks and regions.
#include <numbers>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::check_complaint;
using fixtures::place_of;
using fixtures::plate_with;
using fixtures::read;

namespace {

const std::string shape = "    shape: {box: {size: [0.2, 0.1, 0.009]}}\n    spacing: 0.001\n";

const fixtures::TemporaryFolder& folder() {
  static const fixtures::TemporaryFolder made;
  return made;
}

deck::Deck read_here(const std::string& text) { return deck::read_deck_text(text, "deck.yaml", folder().path()); }

std::string complaint_here(const std::string& text) {
  try {
    read_here(text);
    return "";
  } catch (const fccda::InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("solids in a deck: every shape, added solids, holes, cracks and particle sets are read with units") {
  fixtures::put(folder() / "ice.stl", "solid\n");
  const BodySetup body = read_here(plate_with(shape, R"(    shape: {file: ice.stl, scale: 0.001, file_parts: [floe]}
    spacing: 1 mm
    rotate: [0, 0, 90 deg]
    add: {ridge: {shape: {cylinder: {diameter: 2 cm, height: 0.3, axis: x}}, position: [0, 0, 1 cm], rotate: [0, 45 deg, 0]}}
    holes: {bore: {shape: {sphere: {diameter: 1 cm}}}, slot: {shape: {box: {size: [1, 2, 3]}}}}
    cracks: {notch: {polygon: [[0, 0, 0], [1 cm, 0, 0], [0, 0, 1 cm]]}}
    particle_sets: {edge: {shape: {file: ice.stl}}}
)"))
                             .setup.bodies[0];
  const auto& file = std::get<FileSolid>(body.shape);
  CHECK((file.file == (folder() / "ice.stl").string() && file.scale == 0.001 && file.file_parts == std::vector<std::string>{"floe"}));
  CHECK(body.rotate.z == fixtures::relative(std::numbers::pi / 2, 1e-15));  // rounding of the unit
  REQUIRE(body.add.size() == 1);
  const auto& ridge = std::get<CylinderSolid>(body.add[0].shape);
  CHECK((body.add[0].name == "ridge" && ridge.diameter == 0.02 && ridge.height == 0.3 && ridge.axis.word() == "x"));
  CHECK((body.add[0].position == Vec3d{0, 0, 0.01} && body.add[0].rotate.y > 0.7));
  REQUIRE(body.holes.size() == 2);
  CHECK((std::get<SphereSolid>(body.holes[0].shape).diameter == 0.01 && std::get<BoxSolid>(body.holes[1].shape).size == Vec3d{1, 2, 3}));
  REQUIRE(body.cracks.size() == 1);
  CHECK((body.cracks[0].name == "notch" && body.cracks[0].polygon == std::vector<Vec3d>{{0, 0, 0}, {0.01, 0, 0}, {0, 0, 0.01}}));
  CHECK(std::get<FileSolid>(body.particle_sets.at(0).shape).file == file.file);
}

TEST_CASE("solids in a deck: points are read from their file, cells keep its path") {
  fixtures::put(folder() / "cloud.csv", "x [mm], y [m], z [m], volume [m3]\n1, 2, 3, 4\n");
  const BodySetup points = read_here(plate_with(shape, "    shape: {points: {file: cloud.csv}}\n")).setup.bodies[0];
  const auto& list = std::get<PointsShape>(points.shape);
  CHECK((list.points == std::vector<Vec3d>{{0.001, 2, 3}} && list.volumes == std::vector<double>{4}));
  CHECK(!points.spacing.has_value());
  fixtures::put(folder() / "block.msh", "");
  const BodySetup cells =
      read_here(plate_with(shape, "    shape: {cells: {file: block.msh, scale: 0.001, thickness: 1 mm}}\n    plane: stress\n")).setup.bodies[0];
  CHECK((std::get<CellsShape>(cells.shape).file == (folder() / "block.msh").string() && std::get<CellsShape>(cells.shape).thickness == 0.001));
}

TEST_CASE("solids in a deck: the corner of a crack has three coordinates") {
  const std::string crack = "    cracks: {notch: {polygon: ";
  check_complaint({"    spacing:", crack + "[[0, 0, 0], [1, 0]]}}\n    spacing:", "[1, 0]",
                   "point 2 of polygon has 2 numbers, but three are needed: [x, y, z]. Corners of a plane polygon in order, relative to the body's position "
                   "and in its axes; in a plane body the two ends of a line. Bonds that cross or touch it are cut."});
  check_complaint({"    spacing:", crack + "[[0, 0, 1 s]]}}\n    spacing:", "1 s]",
                   "z of point 1 of polygon is \"1 s\", but that is a time; write a length, for example 9 mm."});
  check_complaint({"    spacing:", crack + "3}}\n    spacing:", "3}}",
                   "polygon is 3, but a list is needed, such as [[0, 0, 0], [1, 0, 0], [1, 1, 0]]. Corners of a plane polygon in order, relative to the body's "
                   "position and in its axes; in a plane body the two ends of a line. Bonds that cross or touch it are cut."});
}

TEST_CASE("solids in a deck: only a single box must be a whole number of spacings") {
  CHECK(fixtures::complaint(plate_with("{box: {size: [0.2, 0.1, 0.009]}}", "{sphere: {diameter: 0.01234}}")) == "");
  const std::string odd = "{box: {size: [0.2, 0.1, 0.0095]}}";
  CHECK(fixtures::complaint(plate_with("{box: {size: [0.2, 0.1, 0.009]}}", odd + "\n    rotate: [0, 0, 1]")) == "");
  CHECK(fixtures::complaint(plate_with("{box: {size: [0.2, 0.1, 0.009]}}", odd + "\n    add: {top: {shape: {sphere: {diameter: 0.02}}}}")) == "");
  CHECK(fixtures::complaint(plate_with("{box: {size: [0.2, 0.1, 0.009]}}", odd + "\n    holes: {top: {shape: {sphere: {diameter: 0.02}}}}")) != "");
}

TEST_CASE("solids in a deck: missing files are reported at their key") {
  const std::string text = plate_with("    spacing:", "    holes: {bore: {shape: {file: none.stl}}}\n    spacing:");
  CHECK(complaint_here(text) ==
        place_of(text, "none.stl") + ": there is no file " + (folder() / "none.stl").string() + "; relative names start at the deck's folder.");
  const std::string cells = plate_with(shape, "    shape: {cells: {file: none.msh}}\n");
  CHECK(complaint_here(cells) ==
        place_of(cells, "none.msh") + ": there is no file " + (folder() / "none.msh").string() + "; relative names start at the deck's folder.");
}

TEST_CASE("solids in a deck: a point cloud has neither spacing nor added solids") {
  fixtures::put(folder() / "cloud.csv", "x [m], y [m], z [m], volume [m3]\n1, 2, 3, 4\n");
  const std::string spaced = plate_with("{box: {size: [0.2, 0.1, 0.009]}}", "{points: {file: cloud.csv}}");
  CHECK(complaint_here(spaced) ==
        place_of(spaced, "0.001\n") +
            ": spacing is given, but the shape of plate is a file of particles, whose positions define the spacing; remove spacing, or give a solid.");
  const std::string united = plate_with(shape, "    shape: {points: {file: cloud.csv}}\n    add: {ball: {shape: {sphere: {diameter: 1}}}}\n");
  CHECK(complaint_here(united) ==
        place_of(united, "add:") +
            ": add is given, but the shape of plate is a file of particles, which cannot be united with a solid; remove add, or give a solid.");
}
