// Boundary conditions in whole simulations: particle sets, columns, contact on constrained particles, threads.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::run;
using fixtures::value;

namespace {

/// A box as a region.
SolidSetup region(const std::string& name, const Vec3d& size, const Vec3d& position) {
  return {.name = name, .shape = BoxSolid{.size = size}, .position = position};
}

/// A plate of 20 × 10 × 4 mm, of which the last two layers at the left are clamped.
Setup clamped_plate() {
  Setup setup;
  setup.time = {.end = 20e-6, .step = 2e-7};
  BodySetup plate = fixtures::body_setup({.size = {0.02, 0.01, 0.004}, .spacing = 0.001});
  plate.name = "plate";
  plate.particle_sets = {region("left", {0.002, 0.01, 0.004}, {-0.009, 0, 0}), region("right", {0.002, 0.01, 0.004}, {0.009, 0, 0})};
  plate.boundary_conditions = {{"clamp", FixedSetup{.particle_set = "left", .directions = {}}}};
  setup.bodies = {plate};
  setup.output.history_interval = 1e-6;
  return setup;
}

/// A sphere that impacts the plate from above at x.
ImpactorSetup sphere(double x) {
  ImpactorSetup impactor;
  impactor.name = "sphere";
  impactor.surface = SphereSurface{.diameter = 0.006, .edge_length = 0.0008};
  impactor.mass = 0.01;
  impactor.position = {x, 0, 0.0052};
  impactor.velocity = {0, 0, -20};
  impactor.free_dofs = {"z"};
  return impactor;
}

}  // namespace

TEST_CASE("boundary conditions: force and work of each are columns of the history, and balance the momentum with those of the impactor") {
  Setup setup = clamped_plate();
  setup.impactors = {sphere(0)};
  Simulation simulation(setup);
  const double before = value(simulation, "total.momentum_z [kg m/s]");
  double impulse = 0;
  while (!simulation.clock().is_finished()) {
    const double row = simulation.clock().time();
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    impulse += value(simulation, "plate.clamp.force_z [N]") * 1e-6;
    CHECK(row < value(simulation, "time [s]"));
  }
  CHECK(value(simulation, "sphere.velocity_z [m/s]") > -19.9);  // contact occurred
  CHECK(impulse > 0);                                           // and the clamp felt it
  // exact up to rounding: all momentum leaves through the clamp
  CHECK(value(simulation, "total.momentum_z [kg m/s]") - before == fixtures::relative(impulse, 1e-9));
  CHECK(value(simulation, "plate.clamp.work [J]") == 0);
}

TEST_CASE("boundary conditions: an impactor does not move constrained particles, and rebounds as from a stiff clamp") {
  Setup setup = clamped_plate();
  setup.impactors = {sphere(-0.009)};  // above the clamped layers, whose contact is the whole of it
  setup.impactors[0].surface = SphereSurface{.diameter = 0.001, .edge_length = 0.0002};
  setup.impactors[0].position = {-0.009, 0, 0.0026};
  setup.time.end = 40e-6;
  Simulation simulation(setup);
  const double before = value(simulation, "total.momentum_z [kg m/s]");
  std::size_t displaced = 0;
  double impulse = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    const Particles& particles = simulation.bodies()[0].particles;
    for (const std::uint32_t slot : particles.slot_of())
      if (particles.reference(slot).x < -0.008) displaced += particles.position.at(slot) != particles.reference(slot);
    if (simulation.monitors().is_due(simulation.clock())) impulse += value(simulation, "plate.clamp.force_z [N]") * 1e-6;
  }
  CHECK(displaced == 0);
  // each step pushes it by mass times depth over the step, a spring, whose energy it gets back but for the steps in which it enters and leaves
  CHECK(value(simulation, "sphere.velocity_z [m/s]") == fixtures::relative(20, 0.08));  // found: 5.5 % less
  CHECK(value(simulation, "total.momentum_z [kg m/s]") - before == fixtures::relative(impulse, 1e-9));
}

TEST_CASE("boundary conditions: one, two and four threads end in the bitwise identical state, with one of each kind") {
  const auto hash = [](int threads) {
    const fixtures::Threads with_several(threads);
    Setup setup = clamped_plate();
    setup.time.end = 4e-6;
    DisplacementSetup course;
    course.velocity = 2;
    setup.bodies[0].boundary_conditions.push_back({"pull", PrescribedSetup{.particle_set = "right", .x = course}});
    setup.bodies[0].boundary_conditions.push_back({"weight", BodyForceSetup{.force_density = {0, 0, -1e7}}});
    setup.bodies[0].boundary_conditions.push_back({"push", PressureSetup{.face = Choice{face_words, 2}, .value = 1e7}});
    setup.bodies[0].boundary_conditions.push_back({"sink", AbsorbingSetup{.particle_set = "right", .face = Choice{face_words, 0}}});
    setup.impactors = {sphere(0)};
    Simulation simulation(setup);
    run(simulation);
    return simulation.state_hash();
  };
  const std::uint64_t one = hash(1);
  CHECK(hash(2) == one);
  CHECK(hash(4) == one);
}

TEST_CASE("boundary conditions: an unknown particle set is refused with its key") {
  Setup setup = clamped_plate();
  setup.bodies[0].boundary_conditions[0].kind = FixedSetup{.particle_set = "lefft"};
  std::string key;
  CHECK(complaint(setup, key) == "body plate has no particle set lefft; did you mean left?");
  CHECK(key == "bodies.plate.boundary_conditions.clamp.fixed.particle_set");
}

TEST_CASE("relax: each increment is a row with its residual and iterations, and loads follow their factors") {
  Setup setup = clamped_plate();
  setup.time = {.end = 2, .relax = RelaxSetup{.increments = 4, .tolerance = 1e-5}};
  setup.output.history_interval.reset();
  setup.bodies[0].boundary_conditions.push_back(
      {"pull", PressureSetup{.particle_set = "right", .face = Choice{face_words, 0}, .value = -1e6, .times = {0, 2}, .factors = {0, 1}}});
  setup.output.probes = {{"end", "plate", {0.0095, 0, 0}}};
  const fixtures::Threads with_one(1);
  Simulation simulation(setup);
  double first = 0;
  for (int increment = 1; increment <= 4; ++increment) {
    simulation.step();
    CAPTURE(increment);
    CHECK(value(simulation, "time [s]") == 0.5 * increment);
    CHECK(value(simulation, "total.residual [-]") <= 1e-5);
    CHECK(value(simulation, "total.iterations [-]") > 0);
    CHECK(value(simulation, "plate.pull.force_x [N]") == fixtures::relative(0.25 * increment * 1e6 * 0.01 * 0.004, 1e-12));
    CHECK(value(simulation, "plate.clamp.force_x [N]") == fixtures::relative(-value(simulation, "plate.pull.force_x [N]"), 1e-4));
    CHECK(value(simulation, "plate.kinetic_energy [J]") == 0);
    const double end = value(simulation, "end.displacement_x [m]");
    if (increment == 1) first = end;
    CHECK(end == fixtures::relative(increment * first, 1e-3));  // linear, but for the tolerance and strains of 1e-5
  }
  CHECK(simulation.clock().is_finished());
  CHECK(value(simulation, "plate.pull.work [J]") == fixtures::relative(value(simulation, "plate.elastic_energy [J]"), 1e-3));
}

TEST_CASE("relax: impactors are refused") {
  Setup setup = clamped_plate();
  setup.time = {.end = 1, .relax = RelaxSetup{}};
  setup.output.history_interval.reset();
  setup.impactors = {sphere(0)};
  std::string key;
  CHECK(complaint(setup, key) ==
        "impactor sphere is not supported with time.relax; prescribe the displacement of the particles in contact instead, or remove time.relax.");
  CHECK(key == "impactors.sphere");
}

TEST_CASE("boundary conditions: a load that starts from zero is not mistaken for an unstable step") {
  Setup setup = clamped_plate();
  setup.bodies[0].boundary_conditions = {
      {"push", PressureSetup{.particle_set = "right", .face = Choice{face_words, 0}, .value = 2e5, .times = {0, 80e-6}, .factors = {0, 1}}}};
  setup.output.history_interval = 2e-7;  // a row a step: in the first ones the load has pushed, but nothing has gone anywhere
  Simulation simulation(setup);
  CHECK_NOTHROW(run(simulation));
  CHECK(value(simulation, "plate.push.work [J]") > 0);
}
