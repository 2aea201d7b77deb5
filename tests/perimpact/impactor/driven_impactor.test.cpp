// An impactor that tables and loads move, watched by gauges, in a whole simulation.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::value;

namespace {

/// A small plate and a cylinder in contact with its edge at t = 0, at rest.
Setup plate_and_cylinder() {
  Setup setup;
  setup.time = {.end = 40e-6, .step = 2e-7};
  BodySetup plate = fixtures::body_setup({.size = {0.04, 0.02, 0.008}, .spacing = 0.002});
  plate.name = "plate";
  setup.bodies = {plate};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.02, .edge_length = 0.001};
  cylinder.mass = 0.1;
  cylinder.position = {0.003, 0.02, 0};
  setup.impactors = {cylinder};
  setup.output.history_interval = 2e-6;
  return setup;
}

/// Energy minus constraint work and work of loads [J].
double own_energy(const Simulation& simulation) {
  const Impactor& impactor = simulation.impactors()[0];
  return value(simulation, "total.energy [J]") - impactor.constraint_work() - impactor.load_work();
}

}  // namespace

TEST_CASE("driven impactor: a table of displacements is followed during impact, and works balance the energy") {
  Setup setup = plate_and_cylinder();
  setup.impactors[0].motion.y.emplace().times = {0, 20e-6, 30e-6};
  setup.impactors[0].motion.y->displacements = {0, -0.5e-3, -0.4e-3};
  Simulation simulation(setup);
  const double first = own_energy(simulation);
  CHECK(value(simulation, "cylinder.velocity_y [m/s]") == fixtures::relative(-25, 1e-12));  // of the table, from the first row on
  while (!simulation.clock().is_finished()) {
    simulation.step();
    const double t = simulation.clock().time();
    const double wanted = t <= 20e-6 ? -25 * t : t <= 30e-6 ? -0.5e-3 + 10 * (t - 20e-6) : -0.4e-3;
    // two hundred roundings of 0.02 m
    REQUIRE(std::fabs(simulation.impactors()[0].body().position_of_com().y - 0.02 - wanted) < 200 * 4e-18);
    // contact only takes energy; interpolated velocities leave a ripple on it, of 0.7 % here and a quarter of that at half the step
    if (simulation.monitors().is_due(simulation.clock())) REQUIRE(own_energy(simulation) < 1.01 * first);
  }
  CHECK(simulation.impactors()[0].constraint_work() > 0.1);
  CHECK(value(simulation, "plate.elastic_energy [J]") > 0.1);
  CHECK(own_energy(simulation) > -0.2 * simulation.impactors()[0].constraint_work());
}

TEST_CASE("driven impactor: a load that presses a free impactor into the plate does the work gained in energy") {
  Setup setup = plate_and_cylinder();
  setup.impactors[0].free_dofs = {"y"};
  LoadSetup push;
  push.name = "push", push.force = {0, -200e3, 0}, push.times = {0, 10e-6, 30e-6}, push.factors = {0, 1, 0};
  setup.impactors[0].loads = {push};
  Simulation simulation(setup);
  while (!simulation.clock().is_finished()) simulation.step();
  const Impactor& cylinder = simulation.impactors()[0];
  CHECK(cylinder.constraint_work() == 0);
  CHECK(cylinder.load_work() > 1);
  CHECK(own_energy(simulation) <= 0.01 * cylinder.load_work());  // the ripple of interpolated velocities
  CHECK(own_energy(simulation) > -0.2 * cylinder.load_work());   // contact takes a little
  // all momentum comes from the load: half of 200 kN over 30 µs
  CHECK(value(simulation, "total.momentum_y [kg m/s]") == fixtures::relative(-0.5 * 200e3 * 30e-6, 1e-10));
}

TEST_CASE("driven impactor: gauges of all parts add up to its force and moment, row by row") {
  Setup setup = plate_and_cylinder();
  ImpactorSetup& cylinder = setup.impactors[0];
  cylinder.velocity = {0, -32, 0}, cylinder.angular_velocity = {300, 0, 200}, cylinder.free_dofs = {"x", "y", "z", "rx", "ry", "rz"};
  setup.contact.impactors.friction = 0.3;
  for (const char* part : {"bottom", "side", "top"}) {
    GaugeSetup gauge;
    gauge.name = part, gauge.surface_parts = {part};
    cylinder.gauges.push_back(gauge);
  }
  GaugeSetup spin;
  spin.name = "spin", spin.axis = Vec3d{0, 0, 3};
  cylinder.gauges.push_back(spin);
  Simulation simulation(setup);
  CHECK(value(simulation, "cylinder.side.force_y [N]") == 0);
  double most = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    for (const char* quantity : {"force_x [N]", "force_y [N]", "force_z [N]", "moment_x [N m]", "moment_y [N m]", "moment_z [N m]"}) {
      double sum = 0;
      for (const char* part : {"bottom", "side", "top"}) sum += value(simulation, std::string("cylinder.") + part + "." + quantity);
      const double whole = value(simulation, std::string("cylinder.") + quantity);
      REQUIRE(std::fabs(sum - whole) < 1e-8);  // dozens of sums of up to 1e5 N in another order: 1e5 × 1e-15 × dozens
      most = fixtures::larger(most, std::fabs(whole));
    }
  }
  CHECK(most > 1e4);
  CHECK_NOTHROW(value(simulation, "cylinder.spin.torque [N m]"));
}

TEST_CASE("driven impactor: a moment of inertia above the sum of the other two is refused, one that equals it is that of a thin plate") {
  const auto refused = [](const Vec3d& inertia) {
    Setup setup;
    setup.time.end = 1e-6;
    setup.bodies = {fixtures::body_setup({.size = {0.02, 0.02, 0.02}})};
    ImpactorSetup ball;
    ball.name = "ball";
    ball.surface = SphereSurface{.diameter = 0.01, .edge_length = 0.002};
    ball.mass = 1;
    ball.position = {0, 0, 1};
    ball.inertia = inertia;
    setup.impactors = {ball};
    return fixtures::complaint(setup);
  };
  CHECK(refused({1, 2, 3}).empty());
  CHECK(refused({3, 1, 2}).empty());
  CHECK(refused({1, 3.1, 2}) ==
        "impactors.ball.inertia: the moment of inertia of ball about y is 3.1 kg m2, but no body has one above the sum of the other two, "
        "here 3 kg m2; correct the numbers or their units.");
}

TEST_CASE("driven impactor: a density yields the same mass and inertia as the mass") {
  Setup by_mass = plate_and_cylinder(), by_density = plate_and_cylinder();
  const Simulation one(by_mass);
  const double volume = one.impactors()[0].surface().report().volume;
  by_density.impactors[0].mass.reset();
  by_density.impactors[0].density = 0.1 / volume;
  const Simulation other(by_density);
  const fccda::RigidBody &a = one.impactors()[0].body(), &b = other.impactors()[0].body();
  CHECK(b.mass() == fixtures::relative(0.1, 1e-14));
  CHECK(b.properties().inertia.row[1].y == fixtures::relative(a.properties().inertia.row[1].y, 1e-14));
  CHECK(a.properties().inertia.row[2].z == fixtures::relative(0.5 * 0.1 * 0.01 * 0.01, 0.01));  // of the round cylinder; panels lie within
}

TEST_CASE("driven impactor: invalid set-ups are refused with their key") {
  std::string key;
  Setup both = plate_and_cylinder();
  both.impactors[0].density = 8000;
  CHECK(complaint(both, key) == "impactor cylinder needs either a mass or a density.");
  CHECK(key == "impactors.cylinder");
  Setup free = plate_and_cylinder();
  free.impactors[0].free_dofs = {"y"};
  free.impactors[0].motion.y.emplace().times = {0};
  free.impactors[0].motion.y->velocities = {1};
  CHECK(complaint(free, key) == "y of cylinder is free, so that its motion cannot be prescribed; remove it from free_dofs, or remove its motion.");
  CHECK(key == "impactors.cylinder.motion.y");
  Setup part = plate_and_cylinder();
  GaugeSetup gauge;
  gauge.name = "bow", gauge.surface_parts = {"sides"};
  part.impactors[0].gauges = {gauge};
  CHECK(complaint(part, key) == "gauge bow: the surface has no part \"sides\"; did you mean side? Its parts are bottom, side, top.");
  CHECK(key == "impactors.cylinder.gauges.bow.surface_parts");
}
