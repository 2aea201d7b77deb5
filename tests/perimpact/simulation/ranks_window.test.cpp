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
#include "perimpact/window_scene.hpp"

using namespace perimpact;

using fixtures::window_spacing;

TEST_CASE("ranks: a moving window on a floating strip that breaks and yields is bitwise that of one rank") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = fixtures::window_strip(folder.path(), true, -1, fixtures::Model::bond_based);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == -24 * window_spacing);
  CHECK(simulation.impactors()[0].entered_inside(0) > 0);
  CHECK(simulation.impactors()[2].record().was_in_contact(0));
  CHECK(fixtures::value(simulation, "body.plastic_dissipation [J]") > 0);
  CHECK(fixtures::value(simulation, "body.sea.flooding_dissipation [J]") > 0);
  const fixtures::Trace one = fixtures::expect_equal_on_ranks(setup);
  CHECK(one.broken_bonds > 0);
}

TEST_CASE("ranks: ice that is crushed in contact, among rubble in a moving window, is bitwise that of one rank") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = fixtures::window_rubble(folder.path());
  setup.impactors.pop_back();  // its surface is open
  setup.contact.impactors.crushing_pressure = 2e9;
  setup.impactors[0].velocity.z = -800, setup.impactors[0].contact_bounds = {};
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == -24 * window_spacing);
  CHECK(fixtures::count_crushed(simulation.bodies()[1].particles) > 5);
  CHECK(simulation.fragments()->contacts() > 10);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}

TEST_CASE("ranks: likewise along y and in the positive direction, with dilatations") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = fixtures::window_strip(folder.path(), false, 1, fixtures::Model::ordinary_state);
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == 24 * window_spacing);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}

TEST_CASE("ranks: rubble of a moving window keeps its contact, friction and compaction, and a body that stays beside it its own") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = fixtures::window_rubble(folder.path());
  Simulation simulation(setup);
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == -24 * window_spacing);
  CHECK(simulation.fragments()->contacts() > 100);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}

TEST_CASE("ranks: the warning about a damaged front, and a body that cannot be a window, are those of one rank") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = fixtures::window_strip(folder.path(), true, 1, fixtures::Model::bond_based);
  setup.bodies[0].boundary_conditions.clear();
  setup.impactors[0].position.x = 24 * window_spacing;  // at the front, of which the root owns nothing
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
  std::get<BoxSolid>(setup.bodies[0].shape).size.x = 62 * window_spacing;
  CHECK_THROWS_WITH_AS(warnings_on(1),
                       "body body cannot be a moving window: it has 62 particles along x, which must be a multiple of 8; make it 0.125 m long along x.",
                       SetupError);
  CHECK_THROWS_WITH_AS(warnings_on(3),
                       "body body cannot be a moving window: it has 62 particles along x, which must be a multiple of 8; make it 0.125 m long along x.",
                       SetupError);
}
