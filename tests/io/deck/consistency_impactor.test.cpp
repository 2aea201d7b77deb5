#include "io/deck/consistency_impactor.hpp"

#include <fstream>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::check_complaint;
using fixtures::complaint;
using fixtures::place_of;
using fixtures::plate_with;
using fixtures::read;

namespace {

/// The plate deck with more keys for the cylinder, which is free along y.
std::string with(const std::string& keys) { return plate_with("    free_dofs:", "    " + keys + "\n    free_dofs:"); }

void check_refused(const std::string& keys, std::string_view at, const std::string& sentence) {
  const std::string text = with(keys);
  CHECK(complaint(text) == place_of(text, at) + ": " + sentence);
}

}  // namespace

TEST_CASE("consistency of impactors: exactly one of mass and density") {
  CHECK(*read(plate_with("mass: 1.57", "density: 8 g/cm3")).setup.impactors[0].density == 8000);
  check_refused("density: 8000", "8000\n    free", "density is given together with mass; keep one of the two.");
  check_complaint({"    mass: 1.57\n", "", "cylinder:", "impactors.cylinder lacks mass [kg] or density [kg/m3]; for example mass: 1.57 kg."});
}

TEST_CASE("consistency of impactors: motion is read with units for each degree of freedom") {
  const ImpactorSetup impactor =
      read(with("motion: {x: {times: [0, 1 ms], velocities: [0, 7.2 km/h]}, rz: {times: [0, 1], displacements: [0, 90 deg]}}")).setup.impactors[0];
  CHECK(impactor.motion.x->velocities[1] == fixtures::relative(2, 1e-15));
  CHECK(impactor.motion.x->times == std::vector{0.0, 1e-3});
  CHECK(impactor.motion.rz->displacements[1] == fixtures::relative(1.5707963267948966, 1e-15));
  CHECK(impactor.motion.of(0) != nullptr);
  CHECK(impactor.motion.of(1) == nullptr);
  CHECK(impactor.motion.of(5)->velocities.empty());
}

TEST_CASE("consistency of impactors: a table has increasing times and as many velocities or displacements") {
  check_refused("motion: {x: {times: [0, 1]}}", "x: {times", "impactors.cylinder.motion.x needs times with velocities or displacements, or a file.");
  check_refused("motion: {x: {times: [0, 1], velocities: [0, 1], displacements: [0, 2]}}", "[0, 2]",
                "displacements is given together with velocities, which determine it; keep one of the two.");
  check_refused("motion: {x: {times: [0, 1], velocities: [0, 1, 2]}}", "[0, 1, 2]", "velocities has 3 values for 2 times; give one for each time.");
  check_refused("motion: {x: {times: [0, 3, 2], displacements: [0, 1, 2]}}", "[0, 3, 2]", "times contains 2 s after 3 s, but times must increase.");
  check_refused("motion: {u: {times: [0], velocities: [1]}}", "u: {times", "u is not a key of impactors.cylinder.motion; did you mean x?");
}

TEST_CASE("consistency of impactors: motion applies to constrained degrees of freedom without another velocity") {
  check_refused("motion: {y: {times: [0], velocities: [1]}}", "y: {times",
                "y is free, so its motion cannot be prescribed; remove y from free_dofs, or remove its motion.");
  const std::string text = plate_with("free_dofs: [y]", "motion: {y: {times: [0], velocities: [1]}}");
  CHECK(complaint(text) ==
        place_of(text, "[0, -32, 0]") + ": y of velocity is not 0, but motion.y prescribes this degree of freedom; set it to 0, or remove that motion.");
  check_refused("angular_velocity: [0, 0, 3]\n    motion: {rz: {times: [0], velocities: [1]}}", "[0, 0, 3]",
                "z of angular_velocity is not 0, but motion.rz prescribes this degree of freedom; set it to 0, or remove that motion.");
}

TEST_CASE("consistency of impactors: an angle against time requires a single axis of rotation") {
  const std::string rz = "rz: {times: [0, 1], displacements: [0, 2]}";
  CHECK(complaint(with("motion: {" + rz + "}")) == "");
  const auto sentence = [](const std::string& why) {
    return "displacements of rz define the attitude only if the impactor rotates about no other axis, because rotations do not commute, but " + why +
           "; constrain the other rotations, or give velocities.";
  };
  check_refused("motion: {" + rz + ", rx: {times: [0], velocities: [1]}}", "[0, 2]", sentence("motion.rx rotates it about another axis"));
  check_refused("angular_velocity: [0, 3, 0]\n    motion: {" + rz + "}", "[0, 2]", sentence("angular_velocity rotates it about y too"));
  const std::string text = plate_with("free_dofs: [y]", "free_dofs: [rx]\n    motion: {" + rz + "}");
  CHECK(complaint(text) == place_of(text, "[0, 2]}") + ": " + sentence("rx is free"));
}

TEST_CASE("consistency of impactors: loads have a force or a moment, factors for their times, and speed factors for their speeds") {
  const ImpactorSetup impactor =
      read(with("loads: {tow: {force: [0, 0, 100 kN], moment: [0, 2 kN m, 0], point: [1, 0, 0], times: [0, 1], factors: [0, 1]}}")).setup.impactors[0];
  CHECK(impactor.loads[0].force.z == 1e5);
  CHECK(impactor.loads[0].moment.y == 2000);
  CHECK(impactor.loads[0].point->x == 1);
  check_refused("loads: {tow: {point: [1, 0, 0]}}",
                "tow:", "impactors.cylinder.loads.tow has neither a force [N] nor a moment [N m]; give one, or remove the load.");
  check_refused("loads: {tow: {force: [1, 0, 0], times: [0, 1]}}", "[0, 1]}", "factors has 0 values for 2 times; give one for each time.");
  check_refused("loads: {tow: {force: [1, 0, 0], times: [1, 0], factors: [1, 1]}}", "[1, 0]", "times contains 0 s after 1 s, but times must increase.");
  check_refused("loads: {tow: {force: [1, 0, 0], speeds: [0, 1], speed_factors: [1]}}", "[1]}",
                "speed_factors has 1 values for 2 speeds; give one for each speed.");
  check_refused("loads: {tow: {force: [1, 0, 0], speeds: [0, 1]}}", "[0, 1]}", "speed_factors has 0 values for 2 speeds; give one for each speed.");
  check_refused("loads: {tow: {force: [1, 0, 0], speeds: [2, 1], speed_factors: [1, 1]}}", "[2, 1]",
                "speeds contains 1 m/s after 2 m/s, but speeds must increase.");
  check_refused("loads: {tow: {moment: [1, 0, 0], speeds: [0, 1], speed_factors: [1, 1]}}", "[0, 1]",
                "speeds are velocities along the force, but impactors.cylinder.loads.tow has none; give a force, or remove speeds and speed_factors.");
  check_refused("loads: {tow: {force: [1 m, 0, 0]}}", "1 m", "x of force is \"1 m\", but that is a length; write a force, for example 5 kN.");
}

TEST_CASE("consistency of impactors: the axis of a gauge is not zero, and parts require panels") {
  const std::string gauge = "gauges: {root: {surface_parts: [side], point: [0, 1, 0], axis: [0, 0, 2]}}";
  CHECK(read(with(gauge)).setup.impactors[0].gauges[0].surface_parts == std::vector<std::string>{"side"});
  check_refused("gauges: {root: {axis: [0, 0, 0]}}", "[0, 0, 0]", "axis is [0, 0, 0], which has no direction; give one, for example [0, 0, 1].");
  std::string text = with(gauge);
  text.replace(text.find("swept"), 5, "analytic");
  CHECK(complaint(text) ==
        place_of(text, "[side]") + ": surface_parts is given, but the analytic detector has no panels; remove surface_parts, or set detector: swept.");
}

TEST_CASE("consistency of impactors: a motion table is read from a file with units, relative to the deck's folder") {
  const fixtures::TemporaryFolder folder;
  const auto file = [&](const std::string& contents) { std::ofstream(folder.path() / "heave.csv", std::ios::binary) << contents; };
  const auto read_there = [&](const std::string& text) { return deck::read_deck_text(text, "deck.yaml", folder.path()); };
  const auto complaint_of = [&](const std::string& text) -> std::string {
    try {
      read_there(text);
    } catch (const fccda::InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string text = with("motion: {x: {file: heave.csv}}"), name = (folder.path() / "heave.csv").string();
  CHECK(complaint_of(text) == place_of(text, "heave.csv") + ": there is no file " + name + "; relative names start at the deck's folder.");

  file("\xEF\xBB\xBF\"time [ms]\", \"velocity [km/h]\"\r\n0, +0\r\n1.5 ,3.6e0\r\n\r\n");
  const TranslationTable heave = *read_there(text).setup.impactors[0].motion.x;
  CHECK(heave.times == std::vector{0.0, 1.5e-3});
  CHECK(heave.velocities[1] == fixtures::relative(1, 1e-15));
  CHECK((heave.displacements.empty() && heave.file.empty()));

  file("time [s], displacement [deg]\n0, 0\n1, 180\n");
  CHECK(read_there(with("motion: {rz: {file: heave.csv}}")).setup.impactors[0].motion.rz->displacements[1] == fixtures::relative(3.14159265358979, 1e-14));
  CHECK(complaint_of(text).starts_with(name + ":1: the unit of a column is [deg], but that is an angle; write a length, for example 9 mm."));

  const auto says = [&](const std::string& contents, const std::string& sentence) {
    file(contents);
    CHECK(complaint_of(text) == name + sentence);
  };
  says("0, 0\n1, 2\n", ":1: the first line is \"0, 0\", but it must name the two columns: \"time [s], velocity [m/s]\" or \"time [s], displacement [m]\".");
  says("time [s], velocity [m/s]\n0, 0\n1; 2\n", ":3: \"1; 2\" is not two comma-separated numbers; correct the row.");
  says("time [s], velocity [m/s]\n0, 0, 1\n", ":2: \"0, 0, 1\" is not two comma-separated numbers; correct the row.");
  says("time [s], velocity [m/s]\n0, nan\n", ":2: \"0, nan\" is not two comma-separated numbers; correct the row.");
  says("time [s], velocity [km/s]\n0, 1e306\n", ":2: the row \"0, 1e306\" has a number that is too large in SI units; correct it.");
  says("time [s], velocity [m/s]\n0, 0\n0, 1\n", ":3: the time 0 s follows 0 s, but times must increase.");
  says("time [s], velocity [m/s]\n", ":1: there are no rows of numbers below the header line; add them.");
  says("", ":1: the first line is \"\", but it must name the two columns: \"time [s], velocity [m/s]\" or \"time [s], displacement [m]\".");
  file("time [s], velocity [m/s]\n0, 0\n");
  const std::string beside = with("motion: {x: {file: heave.csv, times: [0, 7]}}");
  CHECK(complaint_of(beside) == place_of(beside, "[0, 7]") + ": times is given together with file, which contains times and values; keep one of the two.");
}

TEST_CASE("consistency of impactors: refinement and coarsening are read with units") {
  const ImpactorSetup impactor = read(with("coarsen: {max_deviation: 1 mm}\n    refine: {rim: {edge_length: 0.5 mm, box: {size: [1, 2, 3], centre: [0, 1 cm, "
                                           "0]}, surface_part: side}, round: {edge_length: 2 mm, angle: 10 deg}}"))
                                     .setup.impactors[0];
  CHECK(impactor.coarsen->max_deviation == 1e-3);
  CHECK(!impactor.coarsen->max_edge_length);
  REQUIRE(impactor.refine.size() == 2);
  CHECK(impactor.refine[0].name == "rim");
  CHECK(impactor.refine[0].edge_length == 0.5e-3);
  CHECK(impactor.refine[0].box->centre == Vec3d{0, 0.01, 0});
  CHECK(impactor.refine[0].surface_part == "side");
  CHECK(!impactor.refine[0].angle);
  CHECK(*impactor.refine[1].angle == fixtures::relative(0.17453292519943295, 1e-15));
  CHECK(!impactor.refine[1].box);
}

TEST_CASE("consistency of impactors: the angle of a refinement is below half a turn, and has a unit") {
  check_refused("refine: {round: {edge_length: 1 mm, angle: 10}}", "10}}",
                "angle is 10, but it must be above 0 and below 3.141592653589793 rad; write degrees with their unit, as in 30 deg. Restricts refinement to "
                "curved areas: panels are refined until they turn "
                "by at most "
                "this angle, for example 10 deg, but not below edge_length; creases are refined to edge_length. Where absent, flat areas are refined too.");
}

TEST_CASE("consistency of impactors: refinement and coarsening require a detector with panels") {
  const std::string text = fixtures::plate_with("detector: swept", "detector: analytic");
  const auto check = [&](const std::string& key, const std::string& value) {
    std::string deck = text;
    deck.replace(deck.find("    free_dofs:"), 14, "    " + key + ": " + value + "\n    free_dofs:");
    CHECK(complaint(deck) ==
          place_of(deck, key + ":") + ": " + key + " is given, but the analytic detector has no panels; remove " + key + ", or set detector: swept.");
  };
  check("refine", "{rim: {edge_length: 1 mm}}");
  check("coarsen", "{max_deviation: 1 mm}");
}

TEST_CASE("consistency of impactors: the modes of an elastic impactor are a file beside the deck") {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "panel.vtu", "content");
  const auto read = [&](const std::string& keys) { return deck::read_deck_text(with(keys), "deck.yaml", folder.path(), {}).setup.impactors[0].elastic; };
  const auto elastic = read("elastic: {modes: panel.vtu, damping: 0.02, highest_frequency: 3 kHz}");
  CHECK(elastic->modes == (folder / "panel.vtu").string());
  CHECK(*elastic->damping == 0.02);
  CHECK(*elastic->highest_frequency == 3000);
  CHECK_FALSE(read("elastic: {modes: panel.vtu}")->damping);
  CHECK_FALSE(fixtures::read(fixtures::plate).setup.impactors[0].elastic);
  const auto refused = [&](const std::string& keys) -> std::string {
    try {
      read(keys);
      return "";
    } catch (const fccda::InputError& error) {
      return error.what();
    }
  };
  CHECK(refused("elastic: {modes: shell.vtu}") == place_of(with("elastic: {modes: shell.vtu}"), "shell.vtu") + ": there is no file " +
                                                      (folder / "shell.vtu").string() + "; relative names start at the deck's folder.");
  const std::string critical = "elastic: {modes: panel.vtu, damping: 1}";
  CHECK(refused(critical) ==
        place_of(with(critical), "1}\n    free") +
            ": damping is 1, but it must be at least 0 and below 1. Damping of every mode as a ratio of critical damping. Where absent, that of the file; 0 "
            "where it has none.");
}

TEST_CASE("consistency of impactors: an elastic impactor has the swept detector and the vertices of its modes") {
  const std::string elastic = "elastic: {modes: panel.vtu}";
  for (const std::string detector : {"analytic", "published"}) {
    const std::string text = with(elastic);
    CHECK(complaint(text, {"contact.impactors.detector=" + detector}) == place_of(text, "elastic: {modes") + ": cylinder is elastic, but the " + detector +
                                                                             " detector has rigid surfaces only; set detector: swept, or remove elastic.");
  }
  const std::string remedy = " changes the vertices of the surface, on which the modes of elastic are given; remove ";
  check_refused(elastic + "\n    coarsen: {max_deviation: 1 mm}", "coarsen: {max_deviation",
                "coarsen" + remedy + "coarsen, remesh the surface before its modes are computed, or remove elastic.");
  check_refused(elastic + "\n    refine: {all: {edge_length: 1 mm}}", "refine: {all",
                "refine" + remedy + "refine, remesh the surface before its modes are computed, or remove elastic.");
}
