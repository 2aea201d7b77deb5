// Whole simulations on the emulated device. Most steps are not sampled, so that particles stay on the device, and the emulation makes numbers that the host
// reads there without having fetched them NaN.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fixtures/snapshot.hpp"
#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/device/emulated_device.hpp"
#include "perimpact/elastic_modes.hpp"
#include "perimpact/rank_scenes.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "perimpact/simulations.hpp"
#include "perimpact/window_scene.hpp"

using namespace perimpact;

namespace {

constexpr int steps = 200;  // of which every second is sampled, a hundredth of the run

/// The end of rank_scenes' plate, under its cylinder.
Setup plate(const fixtures::BodyOptions& options = {.critical_stretch = 2e-3}) {
  Setup setup = fixtures::struck_plate(options);
  setup.bodies[0].shape = BoxSolid{{0.036, 0.022, 0.006}};
  setup.impactors[0].position.y = 0.0261;
  setup.time = {.end = 12e-6, .step = 12e-6 / steps};
  setup.output.history_interval = setup.time.end / 4;
  return setup;
}

SolidSetup box(const char* name, const Vec3d& size, const Vec3d& position) {
  SolidSetup solid;
  solid.name = name, solid.shape = BoxSolid{size}, solid.position = position;
  return solid;
}

/// Held at its left end and guided at the edge that the cylinder strikes, while its lower edge is pulled down.
Setup constrained_plate() {
  Setup setup = plate();
  BodySetup& body = setup.bodies[0];
  body.particle_sets = {box("left", {0.005, 1, 1}, {-0.018, 0, 0}), box("top", {0.026, 0.005, 1}, {0.004, 0.011, 0}),
                        box("bottom", {0.026, 0.005, 1}, {0.004, -0.011, 0})};
  DisplacementSetup down;
  down.velocity = -2;
  body.boundary_conditions = {{"grip", FixedSetup{.particle_set = "left"}},
                              {"guide", FixedSetup{.particle_set = "top", .directions = {"x"}}},
                              {"pull", PrescribedSetup{.particle_set = "bottom", .y = down}}};
  return setup;
}

/// Under a pressure and with an absorbing end; `weight`: also under a body force on all particles.
Setup loaded_plate(bool weight) {
  Setup setup = plate();
  BodySetup& body = setup.bodies[0];
  body.particle_sets = {box("right", {0.009, 1, 1}, {0.018, 0, 0})};
  body.boundary_conditions = {{"push", PressureSetup{.face = Choice{face_words, 1}, .value = 2e8}},
                              {"sink", AbsorbingSetup{.particle_set = "right", .face = Choice{face_words, 0}}}};
  if (weight) body.boundary_conditions.push_back({"weight", BodyForceSetup{.force_density = {0, -1e9, 0}}});
  return setup;
}

/// A sheet of ice with a dry top, drag, damping and entrained water, held at one end, under a falling ball; `added_mass`: with that in place of the columns.
Setup floating_sheet(double added_mass = 0) {
  BodySetup sheet = fixtures::body_setup({.size = {1.6, 1.0, 0.4}, .spacing = 0.1});
  BondBasedSetup ice;
  ice.youngs_modulus = 1.8e9, ice.density = 900, ice.critical_stretch = 2e-4;
  sheet.material = ice;
  sheet.particle_sets = {box("left", {0.4, 3, 1}, {-0.7, 0, 0})};
  FloatingSetup water;
  water.drag = 1, water.damping = 2, water.entrained_depth = 0.1, water.dry_top = 0.1;
  if (added_mass != 0) water.entrained_depth = water.dry_top = water.damping = 0, water.added_mass = added_mass;
  sheet.boundary_conditions = {{"water", water}, {"edge", FixedSetup{.particle_set = "left"}}};
  Setup setup;
  setup.time = {.end = 4e-3, .step = 4e-3 / steps};
  setup.output.history_interval = 1e-3;
  setup.bodies = {sheet};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.8, .edge_length = 0.1};
  ball.mass = 500;
  ball.position = {-0.4, 0.1, 0.601};
  ball.velocity = {0, 0, -10};
  ball.free_dofs = {"z"};
  setup.impactors = {ball};
  return setup;
}

/// The same sheet with its top just below the level: the columns under the ball are flooded, by their depth and by broken bonds.
Setup drowning_sheet() {
  Setup setup = floating_sheet();
  FloatingSetup& water = std::get<FloatingSetup>(setup.bodies[0].boundary_conditions[0].kind);
  water.level = 0.2005, water.dry_top = 0.004;
  return setup;
}

/// A bullet that breaks a plate before a pole, with contact between fragments.
Setup rubble(Plane plane = Plane::strain, double critical_stretch = 2e-3) {
  Setup setup = fixtures::rubble({.critical_stretch = critical_stretch, .plane = plane});
  setup.time = {.end = 8e-6, .step = 8e-6 / steps};
  setup.output.history_interval = setup.time.end / 2;
  return setup;
}

struct Result {
  std::vector<std::vector<double>> rows;
  std::uint64_t hash = 0;
  std::size_t contacts = 0, broken_bonds = 0;
  double flooding = 0;                 // [J]
  double plastic = 0, compaction = 0;  // [J] dissipated
  double window_travel = 0;            // [m]
};

Result run(Simulation& simulation) {
  Result result;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    result.contacts += simulation.contacts();
    if (simulation.monitors().is_due(simulation.clock())) result.rows.emplace_back(simulation.monitors().row().begin(), simulation.monitors().row().end());
  }
  for (const Body& body : simulation.bodies()) {
    result.broken_bonds += body.internal.broken_bonds();
    result.plastic += body.internal.plastic_dissipation();
  }
  if (simulation.fragments()) result.compaction = simulation.fragments()->compaction_dissipation();
  for (const NamedBoundaryCondition& one : simulation.boundary_conditions()[0].all())
    if (const auto* water = std::get_if<Floating>(&one.boundary)) result.flooding += water->flooding_dissipation();
  for (const MovingWindow& window : simulation.moving_windows()) result.window_travel = std::abs(window.travel());
  result.hash = simulation.state_hash();
  return result;
}

/// Checks that a device computes bitwise what the scalar kernel computes. Returns that.
Result expect_same(const Setup& setup, const std::vector<UserForceOnBody>& user_forces = {}) {
  Simulation on_host(setup, Start(setup), user_forces, {.is_scalar = true});
  const Result expected = run(on_host);
  EmulatedDevice device;
  Simulation on_device(setup, Start(setup), user_forces, {.device = &device});
  const Result found = run(on_device);
  CHECK(found.rows == expected.rows);
  CHECK(found.hash == expected.hash);
  CHECK(found.contacts == expected.contacts);
  CHECK(found.broken_bonds == expected.broken_bonds);
  CHECK(found.flooding == expected.flooding);
  return expected;
}

}  // namespace

TEST_CASE("simulation on a device: an impacted plate is bitwise that of the scalar kernel, with every detector, with several impactors and an elastic one") {
  const ::fixtures::TemporaryFolder folder;
  for (const char* what : {"swept", "analytic", "published", "two impactors", "elastic"}) {
    CAPTURE(what);
    Setup setup = plate();
    if (const std::string_view name(what); name == "analytic" || name == "published") {
      setup.contact.impactors.detector = Choice{detector_words, static_cast<int>(name == "analytic" ? DetectorKind::analytic : DetectorKind::published)};
    } else if (name == "two impactors") {
      ImpactorSetup beside = setup.impactors[0];
      beside.name = "beside", beside.position.x += 0.011, beside.velocity.x = -30;
      setup.impactors.push_back(beside);
    } else if (name == "elastic") {
      setup.impactors[0].angular_velocity = {};
      fixtures::make_elastic(setup.impactors[0], folder / "modes.csv");
    }
    const Result result = expect_same(setup);
    CHECK(result.contacts > 100);
    CHECK(result.broken_bonds > 0);
  }
}

TEST_CASE("simulation on a device: every boundary condition, also where contact displaces constrained particles, is bitwise that of the scalar kernel") {
  for (const Setup& setup : {constrained_plate(), loaded_plate(false), loaded_plate(true), floating_sheet(), floating_sheet(0.7)}) {
    const Result result = expect_same(setup);
    CHECK(result.contacts > 100);
    CHECK(result.broken_bonds > 0);
  }
  Setup intact = drowning_sheet();
  std::get<BondBasedSetup>(intact.bodies[0].material).critical_stretch = 1;
  CHECK(expect_same(intact).flooding > 0);  // by the depth
  CHECK(expect_same(drowning_sheet()).flooding > 0);
}

TEST_CASE("simulation on a device: user forces, material that yields, and contact between fragments are bitwise those of the scalar kernel") {
  const auto spring = [](double, const Body& body, VectorArray& density) {
    for (const std::uint32_t slot : body.particles.slot_of()) density.set(slot, -1e15 * body.particles.displacement(slot));
  };
  CHECK(expect_same(plate(), {{0, "spring", spring}}).contacts > 100);
  Setup yielding = plate({.critical_stretch = 4e-3});
  std::get<OrdinaryStateSetup>(yielding.bodies[0].material).plasticity.emplace().compressive_strength = 400e6;
  CHECK(expect_same(yielding).plastic > 0);
  for (const char* what : {"plane", "solid", "without friction", "dashpots", "compacted"}) {
    CAPTURE(what);
    Setup setup = rubble(std::string_view(what) == "solid" ? Plane::none : Plane::strain);
    FragmentContactSetup& law = setup.contact.fragments;
    if (const std::string_view name(what); name == "without friction") {
      law.friction = 0;
    } else if (name == "dashpots") {
      law.restitution = 0.4;
    } else if (name == "compacted") {
      for (BodySetup& body : setup.bodies) std::get<OrdinaryStateSetup>(body.material).plasticity.emplace().compressive_strength = 300e6;
    }
    const Result result = expect_same(setup);
    CHECK(result.broken_bonds > 100);
    CHECK((result.compaction > 0) == (std::string_view(what) == "compacted"));
  }
}

TEST_CASE("simulation on a device: a body whose window moves is bitwise that of the scalar kernel, also where ice yields and its rubble is in contact") {
  const ::fixtures::TemporaryFolder folder;
  for (Setup setup : {fixtures::window_strip(folder.path(), false, 1, fixtures::Model::ordinary_state), fixtures::window_rubble(folder.path())}) {
    setup.time.step = setup.time.end / steps;
    setup.output.history_interval = setup.time.end / 16;
    const Result result = expect_same(setup);
    CHECK(result.window_travel == 24 * fixtures::window_spacing);
    CHECK(result.broken_bonds > 0);
    if (setup.contact.fragments.law.index == static_cast<int>(FragmentLaw::repulsive)) CHECK(result.plastic > 0);
  }
}

TEST_CASE("simulation on a device: of contact between fragments sums of eights and displacements of blocks travel, where the list of pairs is not new") {
  Setup setup = rubble(Plane::strain, 1);
  constexpr int steps_between_samples = 4;
  setup.time.step = setup.time.end / (100 * steps_between_samples);
  DeviceTraffic of_bodies;
  for (const BodySetup& one : setup.bodies) {
    Body body = make_body(one);
    const DeviceTraffic traffic = BodyOnDevice::traffic_of_step(body);
    of_bodies.uploaded += traffic.uploaded, of_bodies.downloaded += traffic.downloaded;
  }
  EmulatedDevice device;
  Simulation simulation(setup, Start(setup), {}, {.device = &device});
  int compared = 0;
  while (!simulation.clock().is_finished()) {
    const EmulatedDevice::Copied before = device.copied();
    const std::size_t lists = simulation.fragments()->near_pairs().times_made();
    simulation.step();
    const ShortRange& contact = *simulation.fragments();
    if (simulation.clock().step % steps_between_samples < 2 || contact.near_pairs().times_made() != lists || contact.contacts() == 0) continue;
    const DeviceTraffic of_contact = ShortRangeOnDevice::traffic_of_step(contact);
    CAPTURE(simulation.clock().step);
    CHECK(device.copied().uploaded - before.uploaded == of_bodies.uploaded + of_contact.uploaded);
    CHECK(device.copied().downloaded - before.downloaded == of_bodies.downloaded + of_contact.downloaded);
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("simulation on a device: without contact, samples, breaking bonds and floods only sums of boundary conditions travel, and none without any") {
  Setup calm = floating_sheet();
  std::get<BondBasedSetup>(calm.bodies[0].material).critical_stretch = 1;
  for (Setup setup : {plate(), constrained_plate(), loaded_plate(true), calm}) {
    setup.impactors[0].position.y += 10, setup.impactors[0].position.z += 10;
    constexpr int steps_between_samples = 4;
    setup.time.step = setup.time.end / (100 * steps_between_samples);
    Body body = make_body(setup.bodies[0]);
    EmulatedDevice device;
    Simulation simulation(setup, Start(setup), {}, {.device = &device});
    const std::span<const NamedBoundaryCondition> all = simulation.boundary_conditions()[0].all();
    const DeviceTraffic of_body = BodyOnDevice::traffic_of_step(body), of_sums = BoundaryConditionsOnDevice::traffic_of_step(all);
    CHECK((of_sums.downloaded > 0) == !all.empty());
    for (int step = 1; step < 3 * steps_between_samples; ++step) {
      const EmulatedDevice::Copied before = device.copied();
      simulation.step();
      if (step % steps_between_samples < 2) continue;  // sampled, or after it
      CAPTURE(step);
      CHECK(device.copied().uploaded - before.uploaded == of_body.uploaded + of_sums.uploaded);
      CHECK(device.copied().downloaded - before.downloaded == of_body.downloaded + of_sums.downloaded);
      CHECK(device.copied().downloaded - before.downloaded < 8 * body.particles.slots());  // a number of each slot
    }
  }
}

TEST_CASE("simulation on a device: once the impactor has been in contact, of sampled steps sums of eights and the particles in contact travel") {
  Setup setup = plate({});
  constexpr int steps_between_samples = 4;
  setup.time.step = setup.time.end / (100 * steps_between_samples);
  EmulatedDevice device;
  Simulation simulation(setup, Start(setup), {}, {.device = &device});
  const std::size_t slots = simulation.bodies()[0].particles.slots();
  int compared = 0;
  while (!simulation.clock().is_finished()) {
    const std::size_t before = device.copied().downloaded;
    const bool was_in_contact = simulation.impactors()[0].record().was_in_contact(0);
    simulation.step();
    const bool is_sampled = simulation.clock().step % steps_between_samples == 0;
    if (!was_in_contact || !is_sampled) continue;
    const std::size_t of_eights = slots / 8 * 7 * sizeof(double), of_contact = 72 * 4 * (simulation.contacts() + 20);  // due ones too
    CAPTURE(simulation.clock().step);
    CHECK(device.copied().downloaded - before > of_eights);
    CHECK(device.copied().downloaded - before < of_eights + of_contact + slots);
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("simulation on a device: a state and a record change between device and host after any step, with every boundary condition and fragments") {
  const ::fixtures::TemporaryFolder folder;
  for (const Setup& setup : {constrained_plate(), loaded_plate(true), floating_sheet(), rubble(), fixtures::window_rubble(folder.path())}) {
    EmulatedDevice device;
    Simulation whole(setup, Start(setup), {}, {.is_scalar = true});
    std::optional<Simulation> taken_up(std::in_place, setup, Start(setup), std::vector<UserForceOnBody>(), Processor{.device = &device});
    for (int step = 0; step < 40 && !whole.clock().is_finished(); ++step) {
      if (step % 7 == 3) {
        const fixtures::Snapshot snapshot(*taken_up);
        const bool to_host = step % 2 == 0;
        taken_up.emplace(setup, Start(setup), std::vector<UserForceOnBody>(), to_host ? Processor{.is_scalar = true} : Processor{.device = &device});
        snapshot.give(*taken_up);
      }
      whole.step(), taken_up->step();
      CAPTURE(step);
      REQUIRE(fixtures::Snapshot(whole).differences(fixtures::Snapshot(*taken_up)) == std::vector<std::string>{});
    }
  }
}

TEST_CASE("simulation on a device: what it gives after any step is current") {
  Setup setup = plate();
  EmulatedDevice device;
  Simulation simulation(setup, Start(setup), {}, {.device = &device}), on_host(setup, Start(setup), {}, {.is_scalar = true});
  for (int step = 1; step <= 8; ++step) {
    simulation.step();
    on_host.step();
    const Particles &found = simulation.bodies()[0].particles, &expected = on_host.bodies()[0].particles;
    for (const std::uint32_t slot : expected.slot_of()) {
      CHECK(found.position.at(slot) == expected.position.at(slot));
      CHECK(found.velocity.at(slot) == expected.velocity.at(slot));
      CHECK(found.force_density.at(slot) == expected.force_density.at(slot));
    }
  }
}
