// Moving windows on several ranks.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/rank_traces.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

constexpr double spacing = 1.0 / 512;  // [m]
constexpr double top = 2 * spacing;

ImpactorSetup impactor(const std::string& name, const Vec3d& position, const Vec3d& velocity) {
  ImpactorSetup setup;
  setup.name = name;
  setup.surface = SphereSurface{.diameter = 6 * spacing, .edge_length = 0.75 * spacing};
  setup.mass = 0.05;
  setup.position = position;
  setup.velocity = velocity;
  return setup;
}

/// A floating strip of 64 x 8 x 4 cells along an axis, fixed at one end and with an absorbing layer at the other, whose window follows a guide by eight
/// spacings in ten steps. A ball, of which the contact bounds leave out a part, breaks it, and an open sheet is pressed against it.
Setup strip(const std::filesystem::path& folder, bool along_x, double direction, fixtures::Model model) {
  const auto along = [&](double length, double across, double up) { return along_x ? Vec3d{length, across, up} : Vec3d{across, length, up}; };
  Setup setup;
  setup.time = {.end = 32 * 2e-7, .step = 2e-7};
  setup.output.history_interval = 1e-6;
  BodySetup strip = fixtures::body_setup({.size = along(64 * spacing, 8 * spacing, 4 * spacing), .spacing = spacing, .critical_stretch = 4e-4, .model = model});
  SolidSetup front, rear;
  front.name = "front", front.shape = BoxSolid{along(6 * spacing, 1, 1)}, front.position = along(direction * 32 * spacing, 0, 0);
  rear.name = "rear", rear.shape = BoxSolid{along(10 * spacing, 1, 1)}, rear.position = along(-direction * 32 * spacing, 0, 0);
  strip.particle_sets = {front, rear};
  FloatingSetup water;
  water.level = 0.004, water.drag = 1, water.damping = 2, water.dry_top = 0.001;
  AbsorbingSetup end;
  end.particle_set = "rear", end.face = Choice{face_words, (along_x ? 0 : 2) + (direction > 0 ? 1 : 0)}, end.reflection = 0.01;
  strip.boundary_conditions = {{"sea", water}, {"ahead", FixedSetup{.particle_set = "front"}}, {"behind", end}};
  MovingWindowSetup window{.follow = "guide", .start_after = 0};
  window.axis.index = along_x ? 0 : 1;
  strip.moving_window = window;
  setup.bodies = {strip};
  ImpactorSetup ball = impactor("ball", along(0.3 * spacing, 0.2 * spacing, top + 3 * spacing), {0, 0, -400});
  ball.contact_bounds = {BoxRegionSetup{.size = {2 * spacing, 2 * spacing, 6 * spacing}}, Choice{on_exceed_words, 1}};
  ball.free_dofs = {"z"};
  ImpactorSetup sheet = impactor("sheet", along(-9 * spacing, 0.1 * spacing, top + 0.05 * spacing), {0, 0, -150});
  ::fixtures::put(folder / "sheet.obj", "v -0.006 -0.006 0\nv -0.006 0.006 0\nv 0.006 0.006 0\nv 0.006 -0.006 0\nf 1 2 3 4\n");
  sheet.surface = FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  sheet.inertia = Vec3d{1e-6, 1e-6, 1e-6};
  sheet.centre_of_mass = Vec3d{};
  setup.impactors = {ball, impactor("guide", {0, 0, 1}, along(direction * 8400, 0, 0)), sheet};
  setup.contact.impactors.friction = 0.2;
  return setup;
}

}  // namespace

TEST_CASE("ranks: a moving window on a floating strip that breaks and yields is bitwise that of one rank") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = strip(folder.path(), true, -1, fixtures::Model::bond_based);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == -24 * spacing);
  CHECK(simulation.impactors()[0].entered_inside(0) > 0);
  CHECK(simulation.impactors()[2].record().was_in_contact(0));
  CHECK(fixtures::value(simulation, "body.plastic_dissipation [J]") > 0);
  CHECK(fixtures::value(simulation, "body.sea.flooding_dissipation [J]") > 0);
  const fixtures::Trace one = fixtures::expect_equal_on_ranks(setup);
  CHECK(one.broken_bonds > 0);
}

TEST_CASE("ranks: likewise along y and in the positive direction, with dilatations") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = strip(folder.path(), false, 1, fixtures::Model::ordinary_state);
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == 24 * spacing);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}

TEST_CASE("ranks: rubble of a moving window keeps its contact, friction and compaction, and a body that stays beside it its own") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = strip(folder.path(), true, -1, fixtures::Model::bond_based);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  BodySetup block = fixtures::body_setup({.size = {16 * spacing, 4 * spacing, 4 * spacing}, .spacing = spacing, .critical_stretch = 4e-4});
  block.name = "block";
  block.position = {2 * spacing, 0, -4.1 * spacing};
  block.velocity = {0, 0, 40};
  setup.bodies.insert(setup.bodies.begin(), block);
  setup.contact.fragments.law.index = 1;
  setup.contact.fragments.friction = 0.2;
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == -24 * spacing);
  CHECK(simulation.fragments()->contacts() > 100);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}

TEST_CASE("ranks: the warning about a deformed front, and a body that cannot be a window, are those of one rank") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = strip(folder.path(), true, 1, fixtures::Model::bond_based);
  setup.bodies[0].boundary_conditions.clear();
  setup.impactors[0].position.x = 24 * spacing;  // at the front, of which the root owns nothing
  const auto warnings_on = [&](int ranks) {
    std::vector<std::string> warnings;
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      fixtures::run(simulation);
      const std::vector<std::string> closing = simulation.closing_warnings();
      if (its.is_root()) warnings = closing;
    });
    return warnings;
  };
  const std::vector<std::string> one = warnings_on(1);
  CHECK(std::ranges::any_of(one, [](const std::string& sentence) { return sentence.starts_with("The moving window of body body moved although"); }));
  CHECK(warnings_on(3) == one);
  std::get<BoxSolid>(setup.bodies[0].shape).size.x = 62 * spacing;
  CHECK_THROWS_WITH_AS(warnings_on(1),
                       "body body cannot be a moving window: it has 62 particles along x, which must be a multiple of 8; make it 0.125 m long along x.",
                       SetupError);
  CHECK_THROWS_WITH_AS(warnings_on(3),
                       "body body cannot be a moving window: it has 62 particles along x, which must be a multiple of 8; make it 0.125 m long along x.",
                       SetupError);
}
