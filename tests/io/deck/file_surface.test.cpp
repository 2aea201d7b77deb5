// Keys of a surface from a file.
#include <fstream>
#include <numbers>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "io/deck/fixtures.hpp"
#include "mesh/shapes/box.hpp"

using namespace perimpact;
using fixtures::place_of;

namespace {

const fixtures::TemporaryFolder& folder() {
  static const fixtures::TemporaryFolder made;
  return made;
}

/// The plate deck with a surface from the file hull.stl, which is there.
std::string with(const std::string& keys) {
  std::ofstream(folder() / "hull.stl") << "solid\n";
  return fixtures::plate_with("{cylinder: {diameter: 0.05, height: 0.025, axis: z, edge_length: 0.001}}",
                              "{file: hull.stl" + (keys.empty() ? "" : ", " + keys) + "}");
}

FileSurface surface_of(const std::string& keys) {
  return std::get<FileSurface>(deck::read_deck_text(with(keys), "deck.yaml", folder().path()).setup.impactors[0].surface);
}

void check_refused(const std::string& keys, std::string_view at, const std::string& sentence) {
  const std::string text = with(keys);
  try {
    deck::read_deck_text(text, "deck.yaml", folder().path());
    FAIL("accepted: " << keys);
  } catch (const fccda::InputError& error) {
    CHECK(error.what() == place_of(text, at) + ": " + sentence);
  }
}

}  // namespace

TEST_CASE("file surface: without keys the surface is unchanged") {
  const FileSurface surface = surface_of("");
  CHECK(surface.file == (folder() / "hull.stl").string());
  CHECK(surface.file_parts.empty());
  CHECK(surface.scale == 1);
  CHECK((surface.mirror.word() == "none" && surface.mirror_merge.word() == "none" && surface.orientation.word() == "undeclared"));
  CHECK((surface.rotate == Vec3d{} && surface.translate == Vec3d{}));
}

TEST_CASE("file surface: parts, planes, angles and lengths are read with units") {
  const FileSurface surface = surface_of(
      "file_parts: [stem, \"shell 1\"], scale: 0.001, mirror: x, mirror_merge: z, rotate: [90 deg, 0, -0.5], translate: [1 mm, 2, 3 cm], orientation: "
      "reversed");
  CHECK(surface.file_parts == std::vector<std::string>{"stem", "shell 1"});
  CHECK(surface.scale == 0.001);
  CHECK((surface.mirror.word() == "x" && surface.mirror_merge.word() == "z" && surface.orientation.word() == "reversed"));
  CHECK(surface.rotate.x == fixtures::relative(std::numbers::pi / 2, 1e-15));  // rounding of the unit
  CHECK((surface.rotate.y == 0 && surface.rotate.z == -0.5));
  CHECK((surface.translate.x == 1e-3 && surface.translate.y == 2 && surface.translate.z == 0.03));
}

TEST_CASE("file surface: invalid planes, units and angles are refused at their position") {
  check_refused("mirror_merge: w", "w}", "mirror_merge is w, but it must be one of none, x, y, z; did you mean x?");
  check_refused("mirror: port", "port}", "mirror is port, but it must be one of none, x, y, z.");
  check_refused(
      "file_parts: stem", "stem}",
      "file_parts is stem, but a list is needed, such as [a, b]. Names of the parts of the file to read; all where absent. `perimpact mesh` lists them.");
  check_refused("translate: [1 kg, 0, 0]", "1 kg", "x of translate is \"1 kg\", but that is a mass; write a length, for example 9 mm.");
  check_refused("rotate: [0, 0, 90]", "90]",
                "z of rotate is 90, but it must be from -6.2832 to 6.2832 rad; write degrees with their unit, as in 30 deg. Rotates the surface about the axes "
                "x, y and z through the origin, in this order: "
                "[90 deg, 0, 0].");
}

TEST_CASE("file surface: full turns in both directions are valid angles") {
  const FileSurface surface = surface_of("rotate: [360 deg, -360 deg, 180 deg]");
  CHECK(surface.rotate.x == fixtures::relative(2 * std::numbers::pi, 1e-15));
  CHECK(surface.rotate.y == -surface.rotate.x);
}

TEST_CASE("file surface: keys of files are refused for generated shapes and vice versa") {
  const std::string text = fixtures::plate_with("axis: z, edge_length: 0.001}}", "axis: z, edge_length: 0.001}, mirror_merge: y}");
  CHECK(fixtures::complaint(text).starts_with(place_of(text, "mirror_merge") + ": mirror_merge "));
}

TEST_CASE("file surface: panels in memory are taken by their name, for impactors and for bodies, and no file of that name is needed") {
  const fccda::NamedPanels cube(fccda::make_box({.size = {1, 1, 1}, .edge_length = 1}));
  const deck::SurfacesInMemory surfaces{{cube.name(), cube}};
  const std::string keys = fixtures::plate_with("{cylinder: {diameter: 0.05, height: 0.025, axis: z, edge_length: 0.001}}", "{file: " + cube.name() + "}");
  const auto read = [&](const deck::SurfacesInMemory& known) {
    return std::get<FileSurface>(deck::deck_of_tree(deck::parse_document(keys, "deck.yaml"), "deck.yaml", folder().path(), known).setup.impactors[0].surface);
  };
  const FileSurface surface = read(surfaces);
  REQUIRE(surface.panels);
  CHECK((&surface.panels->panels() == &cube.panels() && surface.file == cube.name()));
  CHECK_THROWS_AS(read({}), fccda::InputError);
}
