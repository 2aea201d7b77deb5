#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "fixtures/snapshot.hpp"
#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/resuming.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

/// Two bodies among three impactors: one that spins and rubs and has a gauge and a region that clips it, one driven by a table and pushed by
/// a load, and an open sheet. The first floats. Bonds break, panels share impulses, and the open row of history contains impulses at most steps.
Setup lively(const ::fixtures::TemporaryFolder& folder) {
  Setup setup;
  setup.time = {.end = 4.4e-6, .step = 2e-7};
  setup.output.history_interval = 1.4e-6;
  BodySetup plate = fixtures::body_setup({.size = {0.032, 0.016, 0.008}, .spacing = 0.002, .poissons_ratio = 0.3, .critical_stretch = 1e-3});
  plate.name = "plate";
  BodySetup block = fixtures::body_setup({.size = {0.008, 0.008, 0.008}, .spacing = 0.002, .correction = SurfaceCorrection::volume});
  block.name = "block";
  block.position = {0, -0.0125, 0};
  block.velocity = {0, 5, 0};
  setup.bodies = {plate, block};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.02, .edge_length = 0.001};
  cylinder.mass = 0.1;
  cylinder.position = {0.003, 0.0181, 0};
  cylinder.velocity = {0, -100, 0};
  cylinder.angular_velocity = {0, 0, 800};
  cylinder.free_dofs = {"x", "y", "z", "rx", "ry", "rz"};
  cylinder.contact_bounds = {BoxRegionSetup{.size = {0.02, 0.02, 0.006}}, Choice{on_exceed_words, 1}};
  cylinder.gauges = {{.name = "shaft", .axis = Vec3d{0, 0, 1}}};
  cylinder.floating = {.level = 0.002, .added_mass = 0.5, .damping = 100};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.01, .edge_length = 0.002};
  ball.mass = 0.01;
  ball.position = {-0.01, 0, 0.0091};
  ball.motion.z = TranslationTable{{{0, 8e-6}, {-50, -150}, {}, {}}};
  ball.free_dofs = {"y"};
  ball.loads = {{.name = "push", .force = {0, 1e4, 0}, .times = {0, 8e-6}, .factors = {0, 1}}};
  ImpactorSetup sheet;
  sheet.name = "sheet";
  ::fixtures::put(folder / "sheet.obj", "v -0.01 0 -0.01\nv -0.01 0 0.01\nv 0.01 0 0.01\nv 0.01 0 -0.01\nf 1 2 3 4\n");
  sheet.surface = FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  sheet.mass = 0.01;
  sheet.inertia = Vec3d{1e-6, 1e-6, 1e-6};
  sheet.centre_of_mass = Vec3d{};
  sheet.position = {0.006, -0.0166, 0};
  sheet.velocity = {0, 100, 0};
  setup.impactors = {cylinder, ball, sheet};
  setup.contact.impactors.friction = 0.2;
  setup.output.probes = {{"centre", "plate", {0, 0, 0}}};
  return setup;
}

}  // namespace

TEST_CASE("restart: a restart after every step is bitwise exact") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = lively(folder);
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(fixtures::value(simulation, "plate.broken_bonds [-]") > 0);  // there is something to lose
  CHECK(simulation.impactors()[0].record().was_in_contact(0));
  CHECK(simulation.impactors()[0].entered_inside(0) > 0);
  CHECK(simulation.impactors()[1].record().was_in_contact(0));
  CHECK(simulation.impactors()[0].water_work() != 0);
  CHECK(simulation.impactors()[1].load_work() > 0);
  CHECK(simulation.impactors()[2].record().was_in_contact(1));
  fixtures::expect_same_when_resumed_at_every_step(setup);
}

TEST_CASE("restart: likewise with material that impactors crush") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = lively(folder);
  setup.impactors.pop_back();  // its surface is open
  setup.contact.impactors.crushing_pressure = 1e9;
  setup.impactors[1].motion.z = TranslationTable{{{0, 8e-6}, {-800, -800}, {}, {}}};
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(fixtures::count_crushed(simulation.bodies()[0].particles) > 0);
  fixtures::expect_same_when_resumed_at_every_step(setup);
}

TEST_CASE("restart: likewise with the published and the analytic detector") {
  const ::fixtures::TemporaryFolder folder;
  for (const DetectorKind kind : {DetectorKind::published, DetectorKind::analytic}) {
    Setup setup = lively(folder);
    setup.impactors.pop_back();  // they know closed surfaces only
    setup.contact.impactors.detector.index = static_cast<int>(kind);
    if (kind == DetectorKind::published) setup.contact.impactors.radius_ratio = 0, setup.contact.impactors.friction = 0;
    setup.time.end = 2e-6;
    fixtures::expect_same_when_resumed_at_every_step(setup);
  }
}

TEST_CASE("restart: counts of detection work continue") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = lively(folder);
  setup.impactors.pop_back();
  setup.contact.impactors.detector.index = static_cast<int>(DetectorKind::analytic);  // remembers no distances, so its counts are the same
  Simulation whole(setup), first(setup), second(setup);
  fixtures::run(whole);
  for (int step = 0; step < 17; ++step) first.step();
  const ::fixtures::Snapshot snapshot(first);
  snapshot.give(second);
  fixtures::run(second);
  CHECK(first.impactors()[0].effort(0).points_tested > 0);
  CHECK(second.impactors()[0].effort(0).points_tested == whole.impactors()[0].effort(0).points_tested);
  CHECK(second.impactors()[1].effort(1).points_in_bounds == whole.impactors()[1].effort(1).points_in_bounds);
}

TEST_CASE("restart: a relaxation interrupted within an increment resumes to the bitwise identical state") {
  Setup setup;
  setup.time = {.end = 1, .relax = RelaxSetup{.increments = 2, .tolerance = 1e-8}};
  BodySetup bar = fixtures::body_setup({.size = {0.02, 0.004, 0.004}});
  bar.name = "bar";
  bar.particle_sets = {{.name = "left", .shape = BoxSolid{.size = {0.003, 0.004, 0.004}}, .position = {-0.0085, 0, 0}}};
  bar.boundary_conditions = {{"clamp", FixedSetup{.particle_set = "left"}},
                             {"pull", PressureSetup{.face = Choice{face_words, 0}, .value = -1e8, .times = {0, 1}, .factors = {0, 1}}}};
  setup.bodies = {bar};
  setup.output.history_interval.reset();
  Simulation whole(setup);
  std::optional<Simulation> resumed(std::in_place, setup);
  long iterations = 0, parts = 0;
  while (!whole.clock().is_finished()) {
    const long increment = whole.clock().step;
    whole.step();
    iterations += whole.relaxation()->latest().iterations;
    while (resumed->clock().step == increment) {
      long left = 23;  // iterations at a time
      resumed->step([&](const Relaxed&) { return left-- > 0; });
      const ::fixtures::Snapshot snapshot(*resumed);
      resumed.emplace(setup);
      snapshot.give(*resumed);
      ++parts;
    }
    REQUIRE(::fixtures::Snapshot(whole).differences(::fixtures::Snapshot(*resumed)) == std::vector<std::string>{});
  }
  CHECK(parts > iterations / 23);
}
