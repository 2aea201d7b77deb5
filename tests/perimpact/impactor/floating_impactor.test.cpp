// An impactor that floats, in a whole simulation.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "fixtures/larger.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::value;

namespace {

/// A small block that rests on nothing, over a raft of 2 m × 1 m × 0.5 m with half the density of water, placed at rest in it.
Setup block_and_raft() {
  Setup setup;
  setup.time = {.end = 4, .step = 2e-3};
  BodySetup block = fixtures::body_setup({.size = {0.4, 0.4, 0.4}, .spacing = 0.1});
  std::get<OrdinaryStateSetup>(block.material).youngs_modulus = 1e6;  // so soft that steps of 2 ms are stable
  block.name = "block", block.position = {0, 0, 100};
  setup.bodies = {block};
  ImpactorSetup raft;
  raft.name = "raft";
  raft.surface = BoxSurface{.size = {2, 1, 0.5}, .edge_length = 0.25};
  raft.density = 512.5;
  raft.free_dofs = {"z"};
  raft.floating.emplace();
  setup.impactors = {raft};
  setup.output.history_interval = 0.02;
  return setup;
}

}  // namespace

TEST_CASE("floating impactor: a raft at its equilibrium draft stays, and columns of history give the hydrostatic force") {
  Simulation simulation(block_and_raft());
  fixtures::run(simulation);
  const Impactor& raft = simulation.impactors()[0];
  // 2000 steps of a force that rounds at 1e-12 N on 512 kg
  CHECK(std::fabs(raft.body().position_of_com().z) < 1e-12);
  CHECK(std::fabs(value(simulation, "raft.water_force_z [N]")) < 1e-8);
  CHECK(value(simulation, "raft.displaced_mass [kg]") == fixtures::relative(512.5, 1e-12));
  CHECK(raft.draft() == fixtures::relative(0.25, 1e-12));
  CHECK(*raft.placed_in_water()->rise == fixtures::absolute(0, 1e-12, "m"));
}

TEST_CASE("floating impactor: a raft released above equilibrium oscillates with ρ g A and its added mass, and the work of water balances energy and momentum") {
  Setup setup = block_and_raft();
  setup.impactors[0].position = {0, 0, 0.1};
  setup.impactors[0].floating->added_mass = 0.5;
  Simulation simulation(setup);
  const Impactor& raft = simulation.impactors()[0];
  const double mass = 512.5, omega = std::sqrt(1025 * 9.81 * 2 / (1.5 * mass));
  const double first = value(simulation, "total.energy [J]");
  double worst = 0, impulse = 0, before = 0, fastest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    const double t = simulation.clock().time();
    worst = fixtures::larger(worst, std::fabs(raft.body().position_of_com().z - 0.1 * std::cos(omega * t)));
    const double speed = raft.body().velocity().z;
    REQUIRE(std::fabs(value(simulation, "total.energy [J]") - raft.water_work() - first) < 1e-9);  // of 50 J in 2000 steps
    impulse += value(simulation, "raft.water_force_z [N]") * (t - before);
    before = t;
    REQUIRE(std::fabs(value(simulation, "total.momentum_z [kg m/s]") - impulse) < 1e-8);  // likewise
    fastest = fixtures::larger(fastest, speed);
  }
  CHECK(worst < 0.1 * 0.5 * omega * 2e-3 * 1.05);           // the first kick is half a step late: ω dt/2 of the amplitude
  CHECK(fastest == fixtures::relative(0.1 * omega, 0.01));  // rows are 1 % of a period apart
  CHECK(raft.body().properties().added_mass.z == fixtures::relative(0.5 * mass, 1e-12));
}

TEST_CASE("floating impactor: a body heavier than water has the added mass of its whole displacement") {
  Setup setup = block_and_raft();
  setup.impactors[0].density = 3000;
  setup.impactors[0].floating->added_mass = 0.5;
  const Simulation simulation(setup);
  const Impactor& raft = simulation.impactors()[0];
  CHECK(raft.body().properties().added_mass.z == fixtures::relative(0.5 * 1025, 1e-12));
  CHECK(!raft.placed_in_water()->rise);
  CHECK(raft.placed_in_water()->hydrostatics.force == fixtures::relative((0.5 * 1025 - 3000) * 9.81, 1e-12));
}

TEST_CASE("floating impactor: a load at the rail of a raft causes sinkage by its weight and heel by its hydrostatic stiffness") {
  Setup setup = block_and_raft();
  setup.time.end = 12;
  ImpactorSetup& raft = setup.impactors[0];
  raft.free_dofs = {"z", "rx"};
  raft.floating->damping = 4;
  const double force = 200, beside = 0.1, above = 0.25;
  LoadSetup cargo;
  cargo.name = "cargo", cargo.force = {0, 0, -force}, cargo.point = Vec3d{0, beside, above};
  raft.loads = {cargo};
  Simulation simulation(setup);
  fixtures::run(simulation);
  const double lift = 1025 * 9.81, volume = 0.5 + force / lift, draft = 0.5 * volume;
  const fccda::Pose& pose = simulation.impactors()[0].body().pose();
  CHECK(pose.position().z == fixtures::relative(0.25 - draft, 0.01));  // -1 cm; a heeled box lies 0.02² × 0.1 m² / 2 higher
  // per radian: the waterplane's second moment B³ L/12 = 1/6 m⁴, less what buoyancy under and cargo over the centre of mass turn with it
  const double stiffness = lift * (1.0 / 6 + volume * (0.5 * draft - 0.25)) - force * above;
  const double angle = std::asin(pose.rotation().row[2].y);
  CHECK(angle == fixtures::relative(-force * beside / stiffness, 2e-3));  // 0.02 rad, to its square
  // damping took what cargo and water gave, but for a rest that decays with 2/s: e^-24 of 2 J; rounding is more
  CHECK(simulation.impactors()[0].body().kinetic_energy() < 1e-9);
}

TEST_CASE("floating impactor: an open surface is refused with its key") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = block_and_raft();
  ::fixtures::put(folder / "sheet.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  ImpactorSetup& raft = setup.impactors[0];
  raft.surface = FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  raft.density.reset();
  raft.mass = 10;
  std::string key;
  CHECK(complaint(setup, key) ==
        "the surface of raft is open, so that its displacement is undefined; close the surface (`perimpact mesh` shows where it is open), or remove floating "
        "and give the force as a load.");
  CHECK(key == "impactors.raft.floating");
}
