#include "io/deck/consistency.hpp"

#include <filesystem>
#include <fstream>

#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::check_complaint;
using fixtures::complaint;
using fixtures::place_of;
using fixtures::plate_with;
using fixtures::read;

TEST_CASE("consistency: published sets the seed paper's discretisation, and nothing may contradict it") {
  const BodySetup body = read(plate_with("    spacing:", "    published: true\n    spacing:")).setup.bodies[0];
  CHECK(body.family.word() == "madenci-oterkus");
  CHECK(body.normalisation.word() == "continuum");
  CHECK(body.surface_correction.word() == "none");
  check_complaint({"    spacing:", "    published: true\n    family: hu-ha-bobaru\n    spacing:", "hu-ha-bobaru",
                   "family is given beside published: true, which sets it; remove one of the two."});
  check_complaint({"    spacing:", "    published: true\n    surface_correction: none\n    spacing:", "none",
                   "surface_correction is given beside published: true, which sets it; remove one of the two."});
  CHECK(complaint(plate_with("    spacing:", "    published: false\n    normalisation: continuum\n    spacing:")) == "");
}

TEST_CASE("consistency: a box holds whole spacings, and the nearest sizes that do are named") {
  check_complaint({"0.1, 0.009", "0.1, 0.0095", "[0.2, 0.1, 0.0095]",
                   "z of size is 0.0095 m, which is 9.5 spacings of 0.001 m, but the lattice needs whole ones; take 0.009 m or 0.01 m, or another spacing."});
  check_complaint({"0.1, 0.009", "0.1, 0.0004", "[0.2, 0.1, 0.0004]",
                   "z of size is 0.0004 m, which is 0.4 spacings of 0.001 m, but the lattice needs whole ones; take 0.001 m, or another spacing."});
  CHECK(complaint(plate_with("0.1, 0.009", "0.1, 0.009000008")) == "");  // 0.9e-6 of it
  CHECK(complaint(plate_with("0.1, 0.009", "0.1, 0.00900001")) != "");   // 1.1e-6 of it
}

TEST_CASE("consistency: bodies, impactors and probes share the columns of history.csv") {
  check_complaint({"  cylinder:\n", "  plate:\n", "plate:\n    surface",
                   "the name plate is already taken, but bodies, impactors and probes name columns of history.csv (as does total); choose another."});
  check_complaint({"centre:", "cylinder:", "cylinder: {body",
                   "the name cylinder is already taken, but bodies, impactors and probes name columns of history.csv (as does total); choose another."});
  check_complaint({"  cylinder:\n", "  total:\n",
                   "total:", "the name total is already taken, but bodies, impactors and probes name columns of history.csv (as does total); choose another."});
}

TEST_CASE("consistency: probes and lines are on bodies that exist, at times within the run") {
  check_complaint({"body: plate", "body: plates", "plates", "body is \"plates\", but there is no such body; did you mean plate?"});
  check_complaint({"probes:", "lines: {edge: {body: floe, from: [0, 0, 0], to: [1, 0, 0]}}, probes:", "floe",
                   "body is \"floe\", but there is no such body; known here: plate."});
  check_complaint({"probes:", "lines: {edge: {body: plate, from: [0, 0, 0], to: [0, 0, 0]}}, probes:", "[0, 0, 0]}}",
                   "to is the same point as from, so edge has no length; move one of them."});
  check_complaint({"probes:", "lines: {edge: {body: plate, from: [0, 0, 0], to: [1, 0, 0], times: [1 us, 3 ms]}}, probes:", "[1 us, 3 ms]",
                   "times holds 0.003 s, but the run ends at 0.0002 s; take earlier times or a later end."});
}

TEST_CASE("consistency: the step is not longer than the run") {
  check_complaint({"0.1 us", "1 ms", "1 ms", "step is 0.001 s, which is longer than the whole run of 0.0002 s; make step smaller or end later."});
}

TEST_CASE("consistency: free holds degrees of freedom, each once") {
  check_complaint(
      {"free: [y]", "free: [y, rotation]", "[y, rotation]", "free holds \"rotation\", which is no degree of freedom; known are x, y, z, rx, ry, rz."});
  check_complaint({"free: [y]", "free: [y, y]", "[y, y]", "free holds y twice; keep one."});
  CHECK(read(plate_with("free: [y]", "free: [x, y, z, rx, ry, rz]")).setup.impactors[0].free.size() == 6);
  CHECK(read(plate_with("free: [y]", "free: []")).setup.impactors[0].free.empty());
}

TEST_CASE("consistency: the published detector sees points, without friction") {
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: published")).setup.contact.impactors.radius_ratio == 0);
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: swept")).setup.contact.impactors.radius_ratio == 0.5);
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: published, reading: letter")).setup.contact.impactors.reading.word() ==
        "letter");
  check_complaint({"detector: swept", "detector: published", "0.5}      #",
                   "radius_ratio is 0.5, but the published detector knows particles as points; write radius_ratio: 0, or detector: swept."});
  check_complaint(
      {"detector: swept, friction: 0, radius_ratio: 0.5", "detector: published, friction: 0.3", "0.3",
       "friction is 0.3, but the published detector answers contact as the seed paper does, without friction; write friction: 0, or detector: swept."});
  check_complaint({"detector: swept", "detector: swept, reading: letter", "letter",
                   "reading is letter, but only the published detector reads the paper, and detector is swept; remove reading, or write detector: published."});
}

TEST_CASE("consistency: the analytic detector knows cylinders and spheres") {
  CHECK(complaint(plate_with("swept", "analytic")) == "");
  std::string text = plate_with("swept", "analytic");
  const std::string cylinder = "{cylinder: {diameter: 0.05, height: 0.025, axis: z, panel: 0.001}}";
  text.replace(text.find(cylinder), cylinder.size(), "{box: {size: [1, 1, 1], panel: 0.1}}");
  CHECK(complaint(text) ==
        place_of(text, "analytic") +
            ": detector is analytic, which knows cylinders and spheres only, but the surface of cylinder is another; write detector: swept.");
}

TEST_CASE("consistency: a surface file is looked for from the deck's folder and must exist") {
  const std::string cylinder = "{cylinder: {diameter: 0.05, height: 0.025, axis: z, panel: 0.001}}";
  const std::string text = plate_with(cylinder, "{file: hull.stl, scale: 0.001, outside: normals}");
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "perimpact deck test";
  std::filesystem::create_directories(folder);
  const std::filesystem::path hull = folder / "hull.stl";
  std::filesystem::remove(hull);
  const auto read_there = [&] { return deck::read_deck_text(text, "deck.yaml", folder); };
  try {
    read_there();
    FAIL("a missing file was accepted");
  } catch (const fccda::InputError& error) {
    CHECK(error.what() == place_of(text, "hull.stl") + ": there is no file " + hull.string() + "; relative names start at the deck's folder.");
  }
  std::ofstream(hull) << "solid\n";
  const auto surface = std::get<FileSurface>(read_there().setup.impactors[0].surface);
  CHECK(surface.file == hull.string());
  CHECK(surface.scale == 0.001);
  CHECK(surface.outside.as<OpenSide>() == OpenSide::normals);
  std::filesystem::remove_all(folder);
}
