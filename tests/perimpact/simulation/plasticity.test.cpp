// Ice that yields under pressure in whole simulations: strength of specimens, balance of energy, restart (docs/theory/ice_plasticity.md).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/resuming.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::value;

namespace {

constexpr double modulus = 1.8e9, compressive = 2.3e6, critical = 3.2e-4, spacing = 0.01;
constexpr int across = 10, along = 20;

/// A prism whose ends move along z with opposite velocities, which they reach in a fifth of the run; its ends may slide.
Setup prism(double strain, double time, bool is_plastic) {
  Setup setup;
  setup.time = {.end = time};
  BodySetup ice;
  ice.name = "ice";
  ice.shape = BoxSolid{{across * spacing, across * spacing, along * spacing}};
  ice.spacing = spacing;
  ElasticSetup elastic{modulus, 0.25, 900, critical};
  if (is_plastic) elastic.plasticity = PlasticitySetup{.compressive_strength = compressive};
  ice.material = BondBasedSetup{elastic};
  const double height = 0.5 * along * spacing, travel = 0.5 * strain * (along - 1) * spacing;
  for (const bool top : {false, true}) {
    const std::string name = top ? "top" : "bottom";
    ice.particle_sets.push_back({.name = name, .shape = BoxSolid{{1, 1, spacing}}, .position = {0, 0, (top ? 1 : -1) * (height - 0.5 * spacing)}});
    PrescribedSetup ends{.particle_set = name};
    const double speed = (top ? 1 : -1) * travel / (0.9 * time);
    ends.z.emplace();
    ends.z->times = {0, 0.2 * time};
    ends.z->velocities = {0, speed};
    ice.boundary_conditions.push_back({name, ends});
  }
  setup.bodies = {ice};
  setup.output.history_interval = time / 200;
  return setup;
}

struct Loaded {
  double strongest = 0;       // [Pa] largest mean stress of both ends
  double balance_error = 0;   // [J] largest
  double work = 0, flow = 0;  // [J]
};

Loaded load(const Setup& setup, double sign) {
  Simulation simulation(setup);
  const double area = across * across * spacing * spacing;
  Loaded result;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    const double pull = 0.5 * (value(simulation, "ice.top.force_z [N]") - value(simulation, "ice.bottom.force_z [N]"));
    result.strongest = fixtures::larger(result.strongest, sign * pull / area);
    result.balance_error = fixtures::larger(result.balance_error, std::fabs(value(simulation, "total.energy_balance_error [J]")));
  }
  result.work = value(simulation, "ice.top.work [J]") + value(simulation, "ice.bottom.work [J]");
  if (simulation.bodies()[0].internal.plastic()) result.flow = value(simulation, "ice.plastic_dissipation [J]");
  return result;
}

/// A ball of steel that is driven into a block of ice.
Setup indented(double end) {
  Setup setup;
  setup.time = {.end = end};
  BodySetup ice;
  ice.name = "ice";
  ice.shape = BoxSolid{{0.9, 0.8, 0.5}};
  ice.spacing = 0.05;
  ElasticSetup elastic{modulus, 0.25, 900, critical};
  elastic.plasticity = PlasticitySetup{.compressive_strength = compressive};
  ice.material = BondBasedSetup{elastic};
  ice.particle_sets = {{.name = "bottom", .shape = BoxSolid{{2, 2, 0.1}}, .position = {0, 0, -0.2}}};
  ice.boundary_conditions = {{"clamp", FixedSetup{.particle_set = "bottom"}}};
  setup.bodies = {ice};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.6, .edge_length = 0.05};
  ball.mass = 100;
  ball.position = {0.013, 0.007, 0.25 + 0.3 + 0.001};
  ball.velocity = {0, 0, -5};
  setup.impactors = {ball};
  setup.contact.fragments.law.index = static_cast<int>(FragmentLaw::repulsive);
  setup.output.history_interval = end / 50;
  return setup;
}

/// A block of ice that is crushed, thrown against a plate of steel: a step strains it by about 1 %, several times its strength over its modulus.
Setup thrown(double step, double history_interval) {
  Setup setup = indented(2e-3);
  setup.time.step = step;
  BodySetup& ice = setup.bodies[0];
  ice.particle_sets.clear(), ice.boundary_conditions.clear();
  ice.shape = BoxSolid{{0.6, 0.5, 0.5}};
  ice.position = {0, 0, 0.2505};
  ice.velocity = {0, 0, -20};
  ElasticSetup elastic{modulus, 0.25, 900, critical};
  elastic.plasticity = PlasticitySetup{
      .compressive_strength = compressive, .failure_strain = 0.003, .failure_width = 3, .failure_pressure = 0.2, .friction_angle = std::numbers::pi / 6};
  ice.material = OrdinaryStateSetup{elastic};
  setup.impactors[0].surface = BoxSurface{.size = {2, 2, 0.2}, .edge_length = 0.4};
  setup.impactors[0].position = {0, 0, -0.1};
  setup.impactors[0].velocity = {};
  setup.output.history_interval = history_interval;
  return setup;
}

constexpr double thrown_step = 1.9e-5;

}  // namespace

TEST_CASE("plasticity: a prism in compression carries its compressive strength, and its energy closes while it yields") {
  const Loaded pressed = load(prism(-3e-3, 12e-3, true), -1);
  CHECK(pressed.strongest == fixtures::relative(compressive, 0.05));  // faces of the lattice, waves of the loading
  CHECK(pressed.flow > 0.3 * pressed.work);
  CHECK(pressed.balance_error < 1e-3 * pressed.work);
}

TEST_CASE("plasticity: a prism in tension is as strong as without plasticity") {
  const Loaded plastic = load(prism(6e-4, 6e-3, true), 1), elastic = load(prism(6e-4, 6e-3, false), 1);
  CHECK(plastic.strongest == fixtures::relative(elastic.strongest, 0.002));  // strains of 3e-4, and the row of history in which it parts
  CHECK(plastic.flow == 0);
}

TEST_CASE("plasticity: a run that is left off after every step goes on to the last bit, while ice yields and breaks") {
  Setup setup = indented(4e-3);
  fixtures::expect_same_when_resumed_at_every_step(setup);
  Simulation whole(setup);
  fixtures::run(whole);
  CHECK(value(whole, "ice.plastic_dissipation [J]") > 0);
  CHECK(value(whole, "ice.broken_bonds [-]") > 0);
}

TEST_CASE("plasticity: the number of threads changes nothing while ice is crushed") {
  const auto hash = [](int threads) {
    const fixtures::Threads with_several(threads);
    Simulation simulation(indented(6e-3));
    fixtures::run(simulation);
    return simulation.state_hash();
  };
  CHECK(hash(1) == hash(3));
}

TEST_CASE("plasticity: the energy of an indentation closes, debris and plastic flow included, and what was squeezed together does not fly apart") {
  Simulation simulation(indented(20e-3));
  double largest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (simulation.monitors().is_due(simulation.clock())) largest = fixtures::larger(largest, std::fabs(value(simulation, "total.energy_balance_error [J]")));
  }
  const double work = -value(simulation, "ball.contact_work [J]");
  CHECK(value(simulation, "ice.plastic_dissipation [J]") > 0.2 * work);
  CHECK(largest < 1e-3 * work);
  CHECK(value(simulation, "ice.kinetic_energy [J]") < 0.05 * work);  // 1.5 %
}

TEST_CASE("plasticity: in a fast impact neither the force nor the dissipation depends on the time step, and the energy closes") {
  struct Impact {
    double strongest = 0, flow = 0, balance_error = 0;
  };
  const auto impact = [](double step) {
    Simulation simulation(thrown(step, 4 * thrown_step));
    Impact result;
    while (!simulation.clock().is_finished()) {
      simulation.step();
      if (!simulation.monitors().is_due(simulation.clock())) continue;
      result.strongest = fixtures::larger(result.strongest, std::fabs(value(simulation, "ball.force_z [N]")));
      result.balance_error = fixtures::larger(result.balance_error, std::fabs(value(simulation, "total.energy_balance_error [J]")));
    }
    result.flow = value(simulation, "ice.plastic_dissipation [J]");
    return result;
  };
  const Impact coarse = impact(thrown_step), fine = impact(0.25 * thrown_step);
  const double energy = 0.5 * 900 * 0.6 * 0.5 * 0.5 * 20 * 20;
  MESSAGE("force ", coarse.strongest, " ", fine.strongest, " N, flow ", coarse.flow, " ", fine.flow, " of ", energy, " J, balance ", coarse.balance_error, " ",
          fine.balance_error);
  CHECK(coarse.strongest == fixtures::relative(fine.strongest, 0.1));
  CHECK(coarse.flow == fixtures::relative(fine.flow, 0.1));
  CHECK(fine.flow > 0.1 * energy);
  CHECK(coarse.balance_error < 2e-3 * energy);
}

TEST_CASE("plasticity: what flow affects is all that needs a second evaluation, whatever the number of threads") {
  const auto hash = [](int threads, double history_interval) {
    const fixtures::Threads with_several(threads);
    Simulation simulation(thrown(thrown_step, history_interval));
    fixtures::run(simulation);
    return simulation.state_hash();
  };
  const std::uint64_t expected = hash(1, 2e-3);
  CHECK(hash(1, thrown_step) == expected);  // with the energy of every step, all packs are evaluated again
  CHECK(hash(3, 2e-3) == expected);
}
