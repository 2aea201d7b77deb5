#include "io/deck/consistency_boundary.hpp"

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

/// The plate deck with a boundary condition `grip` of the plate.
std::string with(const std::string& boundary) {
  return plate_with("    horizon_ratio:", "    boundary_conditions: {grip: {" + boundary + "}}\n    horizon_ratio:");
}

void check_refused(const std::string& boundary, std::string_view at, const std::string& sentence) {
  const std::string text = with(boundary);
  CHECK(complaint(text) == place_of(text, at) + ": " + sentence);
}

template <class Kind>
Kind boundary(const std::string& text) {
  return std::get<Kind>(read(with(text)).setup.bodies[0].boundary_conditions[0].kind);
}

/// The plate deck without an impactor, relaxed.
std::string relaxed(const std::string& old_text = "title:", const std::string& new_text = "title:") {
  std::string text = fixtures::plate;
  const auto change = [&](std::string_view from, std::string_view to) { text.replace(text.find(from), from.size(), to); };
  change("step: 0.1 us", "relax: {increments: 4}");
  change("history_interval: 1 us, ", "");
  text.erase(text.find("impactors:"), text.find("contact:") - text.find("impactors:"));
  change(old_text, new_text);
  return text;
}

}  // namespace

TEST_CASE("consistency of boundary conditions: each kind is read with its units and defaults") {
  CHECK(boundary<FixedSetup>("fixed: {}").directions.empty());
  CHECK(boundary<FixedSetup>("fixed: {particle_set: left, directions: [x, z]}").particle_set == "left");
  const auto prescribed = boundary<PrescribedSetup>("prescribed: {x: {velocity: 36 km/h}, y: {times: [0, 1 ms], displacements: [0, 2 mm]}}");
  CHECK(*prescribed.x->velocity == fixtures::relative(10, 1e-15));
  CHECK(prescribed.y->displacements == std::vector{0.0, 0.002});
  CHECK(!prescribed.z);
  CHECK(boundary<BodyForceSetup>("body_force: {force_density: [0, 0, -8 kN/m3]}").force_density == Vec3d{0, 0, -8000});
  const auto floating = boundary<FloatingSetup>("floating: {level: -20 mm, gravity: 981 cm/s2, damping: 2 1/s}");
  CHECK(*floating.level == -0.02);
  CHECK(floating.gravity == 9.81);
  CHECK(floating.damping == 2);
  const auto pressure = boundary<PressureSetup>("pressure: {face: -y, value: 2 bar, area: 4 cm2, times: [0, 1 s], factors: [0, 1]}");
  CHECK(pressure.face.word() == "-y");
  CHECK(pressure.value == 2e5);
  CHECK(*pressure.area == fixtures::relative(4e-4, 1e-15));
  CHECK(boundary<AbsorbingSetup>("absorbing: {particle_set: sink, face: +x}").reflection == 1e-3);
}

TEST_CASE("consistency of boundary conditions: the water that a body entrains is given once") {
  check_refused("floating: {added_mass: 1, entrained_depth: 2.625}", "2.625}",
                "entrained_depth is given beside added_mass, and both are the water that moves with the body; remove one of the two.");
  CHECK(boundary<FloatingSetup>("floating: {entrained_depth: 450 cm}").entrained_depth == 4.5);
  CHECK(boundary<FloatingSetup>("floating: {dry_top: 30 cm}").dry_top == 0.3);
}

TEST_CASE("consistency of boundary conditions: fixed directions") {
  check_refused("fixed: {directions: [x, r]}", "[x, r]", "directions contains \"r\", which is not a direction; known are x, y, z.");
  check_refused("fixed: {directions: [x, x]}", "[x, x]", "directions contains x twice; keep one.");
}

TEST_CASE("consistency of boundary conditions: a prescribed motion is one velocity, one displacement, a table or a file") {
  check_refused("prescribed: {particle_set: left}", "prescribed:", "bodies.plate.boundary_conditions.grip.prescribed prescribes no motion; give x, y or z.");
  check_refused("prescribed: {x: {}}", "x: {}",
                "bodies.plate.boundary_conditions.grip.prescribed.x needs a velocity or a displacement, times with either, or a file.");
  check_refused("prescribed: {x: {velocity: 1, displacement: 0}}", "0}}",
                "displacement is given together with velocity, which applies at all times; keep one of the two.");
  check_refused("prescribed: {x: {displacement: 1, times: [0]}}", "[0]",
                "times is given together with displacement, which applies at all times; keep one of the two.");
  check_refused("prescribed: {x: {times: [0, 1], velocities: [3]}}", "[3]", "velocities has 1 values for 2 times; give one for each time.");
  check_refused("prescribed: {x: {times: [1, 1], velocities: [3, 4]}}", "[1, 1]", "times contains 1 s after 1 s, but times must increase.");
}

TEST_CASE("consistency of boundary conditions: a displacement history is read from a file relative to the deck's folder") {
  const fixtures::TemporaryFolder folder;
  std::ofstream(folder.path() / "pull.csv") << "time [ms], displacement [mm]\n0, 0\n2, 0.5\n";
  const auto deck = deck::read_deck_text(with("prescribed: {z: {file: pull.csv}}"), "deck.yaml", folder.path(), {});
  const DisplacementSetup course = *std::get<PrescribedSetup>(deck.setup.bodies[0].boundary_conditions[0].kind).z;
  CHECK(course.times == std::vector{0.0, 0.002});
  CHECK(course.displacements == std::vector{0.0, 0.0005});
  CHECK(course.file.empty());
}

TEST_CASE("consistency of boundary conditions: loads without effect and factors that do not match their times are refused") {
  check_refused("body_force: {force_density: [0, 0, 0]}", "[0, 0, 0]",
                "force_density is [0, 0, 0], which has no effect; give a value, or remove the boundary condition.");
  check_refused("pressure: {face: +x, value: 0}", "0}}", "value is 0, which has no effect; give a value, or remove the boundary condition.");
  check_refused("pressure: {face: +x, value: 1, times: [0, 1]}", "[0, 1]", "factors has 0 values for 2 times; give one for each time.");
  check_refused("body_force: {force_density: [1, 0, 0], times: [0, 0], factors: [1, 2]}", "[0, 0], f",
                "times contains 0 s after 0 s, but times must increase.");
}

TEST_CASE("consistency of boundary conditions: a 2-D body has no motion along z") {
  const auto check_plane = [](const std::string& boundary, std::string_view at, const std::string& key) {
    const std::string text = plate_with("    horizon_ratio:", "    plane: stress\n    boundary_conditions: {grip: {" + boundary + "}}\n    horizon_ratio:");
    CHECK(complaint(text) == place_of(text, at) + ": " + key + " acts along z, but body plate is 2-D and its particles stay in the plane; remove it.");
  };
  check_plane("prescribed: {z: {velocity: 1}}", "z: {", "z");
  check_plane("body_force: {force_density: [0, 0, 1]}", "[0, 0, 1]", "force_density");
  check_plane("pressure: {face: -z, value: 1}", "-z", "face");
  check_plane("absorbing: {particle_set: a, face: +z}", "+z", "face");
}

TEST_CASE("consistency of relaxation: keys of dynamics are refused") {
  CHECK(complaint(relaxed()).empty());
  CHECK(read(relaxed()).setup.time.relax->increments == 4);
  const auto refused = [](const std::string& old_text, const std::string& new_text, std::string_view at, const std::string& sentence) {
    const std::string text = relaxed(old_text, new_text);
    CHECK(complaint(text) == place_of(text, at) + ": " + sentence);
  };
  refused("relax:", "step: 1 us, relax:", "1 us,", "step is given together with relax, which has increments instead of time steps; remove one of the two.");
  refused("frames: 40", "history_interval: 2 us", "2 us", "history_interval is given, but relax writes one row per increment; remove history_interval.");
  refused("law: none", "law: repulsive", "repulsive", "law is repulsive, but relax does not support short-range contact; remove one of the two.");
  refused("radius_ratio: 0.5}", "radius_ratio: 0.5, crushing_pressure: 2e6}", "2e6",
          "crushing_pressure acts in contact with impactors, but relax computes equilibrium states without contact; remove one of the two.");
  refused("    horizon_ratio", "    velocity: [0, 0, 1]\n    horizon_ratio", "[0, 0, 1]",
          "velocity is not 0, but relax computes equilibrium states without motion; remove one of the two.");
  refused("    horizon_ratio", "    boundary_conditions: {sink: {absorbing: {particle_set: a, face: +x}}}\n    horizon_ratio", "absorbing",
          "absorbing damps waves, but relax computes equilibrium states without motion; remove one of the two.");
}
