#include <doctest/doctest.h>

#include <functional>

#include "fixtures/snapshot.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

namespace perimpact {

namespace {

/// Two bodies between three impactors: one that spins and rubs and has a gauge, one driven by a table and pushed by a load, an open one
/// with a region. Bonds break, panels share pushes, and the row of history that is open at most steps holds pushes.
Setup lively() {
  Setup setup;
  setup.time = {.end = 6e-6, .step = 2e-7};
  setup.output.history = 1.4e-6;
  BodySetup plate = fixtures::body_setup({.size = {0.032, 0.016, 0.008}, .spacing = 0.002, .poissons_ratio = 0.3, .critical_stretch = 1e-3});
  plate.name = "plate";
  BodySetup block = fixtures::body_setup({.size = {0.008, 0.008, 0.008}, .spacing = 0.002, .correction = SurfaceCorrection::volume});
  block.name = "block";
  block.position = {0, -0.0125, 0};
  block.velocity = {0, 5, 0};
  setup.bodies = {plate, block};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.02, .panel = 0.001};
  cylinder.mass = 0.1;
  cylinder.position = {0.003, 0.0181, 0};
  cylinder.velocity = {0, -100, 0};
  cylinder.angular_velocity = {0, 0, 800};
  cylinder.free = {"x", "y", "z", "rx", "ry", "rz"};
  cylinder.region = {BoxRegionSetup{.size = {0.02, 0.02, 0.006}}, Choice{beyond_region_words, 1}};
  cylinder.gauges = {{.name = "shaft", .axis = Vec3d{0, 0, 1}}};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.01, .panel = 0.002};
  ball.mass = 0.01;
  ball.position = {-0.01, 0, 0.0091};
  ball.motion.z = TranslationTable{{{0, 8e-6}, {-50, -150}, {}, {}}};
  ball.free = {"y"};
  ball.loads = {{.name = "push", .force = {0, 1e4, 0}, .times = {0, 8e-6}, .factors = {0, 1}}};
  setup.impactors = {cylinder, ball};
  setup.contact.impactors.friction = 0.2;
  setup.output.probes = {{"centre", "plate", {0, 0, 0}}};
  return setup;
}

/// Runs to the end, leaving off after every step: a simulation made anew is given the state and goes on.
void expect_same_when_resumed_at_every_step(const Setup& setup) {
  Simulation whole(setup);
  std::optional<Simulation> resumed(std::in_place, setup);
  while (!whole.clock().is_finished()) {
    const ::fixtures::Snapshot snapshot(*resumed);
    resumed.emplace(setup);
    snapshot.give(*resumed);
    whole.step(), resumed->step();
    CAPTURE(whole.clock().step);
    REQUIRE(resumed->clock().step == whole.clock().step);
    REQUIRE(resumed->state_hash() == whole.state_hash());
    const auto row = whole.monitors().row(), again = resumed->monitors().row();
    REQUIRE(std::vector(again.begin(), again.end()) == std::vector(row.begin(), row.end()));
    for (std::size_t i = 0; i < whole.impactors().size(); ++i) {
      const fccda::PanelLoads &loads = whole.impactors()[i].record().panels(), &loads_again = resumed->impactors()[i].record().panels();
      const auto impulses = loads.since_start(), impulses_again = loads_again.since_start();
      for (std::size_t panel = 0; panel < impulses.size(); ++panel) {
        const bool same = impulses_again[panel].impulse == impulses[panel].impulse &&
                          loads_again.interval_pressure()[panel] == loads.interval_pressure()[panel] &&
                          loads_again.peak_pressure()[panel] == loads.peak_pressure()[panel];
        REQUIRE(same);
      }
    }
  }
  CHECK(resumed->closing_warnings() == whole.closing_warnings());
}

}  // namespace

TEST_CASE("resume: a run left off after every step and taken up by a simulation made anew is the same to the last bit") {
  const Setup setup = lively();
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(fixtures::value(simulation, "plate.broken_bonds [-]") > 0);  // there is something to lose
  CHECK(simulation.impactors()[0].record().touched(0));
  CHECK(simulation.impactors()[0].entered_inside(0) > 0);
  CHECK(simulation.impactors()[1].record().touched(0));
  CHECK(simulation.impactors()[1].work_of_loads() > 0);
  expect_same_when_resumed_at_every_step(setup);
}

TEST_CASE("resume: likewise with the published and the analytic detector") {
  for (const DetectorKind kind : {DetectorKind::published, DetectorKind::analytic}) {
    Setup setup = lively();
    setup.contact.impactors.detector.index = static_cast<int>(kind);
    if (kind == DetectorKind::published) setup.contact.impactors.radius_ratio = 0, setup.contact.impactors.friction = 0;
    setup.time.end = 3e-6;
    expect_same_when_resumed_at_every_step(setup);
  }
}

TEST_CASE("resume: counts of the work of detection go on") {
  Setup setup = lively();
  setup.contact.impactors.detector.index = static_cast<int>(DetectorKind::analytic);  // remembers no distances, so its counts are the same
  Simulation whole(setup), first(setup), second(setup);
  fixtures::run(whole);
  for (int step = 0; step < 17; ++step) first.step();
  const ::fixtures::Snapshot snapshot(first);
  snapshot.give(second);
  fixtures::run(second);
  CHECK(first.impactors()[0].effort(0).points_asked > 0);
  CHECK(second.impactors()[0].effort(0).points_asked == whole.impactors()[0].effort(0).points_asked);
  CHECK(second.impactors()[1].effort(1).points_in_region == whole.impactors()[1].effort(1).points_in_region);
}

}  // namespace perimpact
