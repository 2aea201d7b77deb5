// Elastic impactors on several ranks, and after a restart.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "fixtures/snapshot.hpp"
#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/elastic_modes.hpp"
#include "perimpact/rank_scenes.hpp"
#include "perimpact/rank_traces.hpp"

using namespace perimpact;

namespace {

/// An elastic cylinder that flies in x and y, or is guided there, breaks the edge of a plate, which a rigid ball presses against it from aside.
Setup plate(const std::filesystem::path& folder, bool is_free, double friction) {
  Setup setup = fixtures::struck_plate({.poissons_ratio = 0.3, .critical_stretch = 2e-3});
  setup.time.end = 1e-5;
  setup.output.history_interval = 1e-6;
  ImpactorSetup& cylinder = setup.impactors[0];
  cylinder.angular_velocity = {};
  if (!is_free) cylinder.free_dofs.clear();
  fixtures::make_elastic(cylinder, folder / "modes.csv");
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.012, .edge_length = 0.002};
  ball.mass = 0.002;
  ball.position = {0.0225, 0.0285, 0};
  ball.velocity = {-40, -120, 0};
  ball.free_dofs = {"x", "y"};
  setup.impactors.push_back(ball);
  setup.contact.impactors.friction = friction;
  return setup;
}

/// In place of the cylinder an open sheet of 6 x 4 panels that faces the edge.
Setup plate_below_sheet(const std::filesystem::path& folder) {
  Setup setup = plate(folder, true, 0.2);
  ImpactorSetup& sheet = setup.impactors[0];
  std::ostringstream text;
  for (int i = 0; i <= 6; ++i)
    for (int k = 0; k <= 4; ++k) text << "v " << 0.005 * (i - 3) << " 0 " << 0.005 * (k - 2) << '\n';
  for (int i = 0; i < 6; ++i)
    for (int k = 1; k <= 4; ++k) text << "f " << 5 * i + k << ' ' << 5 * i + k + 5 << ' ' << 5 * i + k + 6 << ' ' << 5 * i + k + 1 << '\n';
  fixtures::put(folder / "sheet.obj", text.str());
  sheet.surface = FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  sheet.inertia = Vec3d{1e-6, 1e-6, 1e-6};
  sheet.centre_of_mass = Vec3d{};
  sheet.position.y = 0.0213;
  fixtures::make_elastic(sheet, folder / "modes.csv");
  return setup;
}

}  // namespace

TEST_CASE("ranks: the motion and modes of an elastic impactor that breaks a plate beside a rigid one are bitwise those of one rank") {
  const ::fixtures::TemporaryFolder folder;
  for (const bool is_free : {true, false}) {
    CAPTURE(is_free);
    const fixtures::Trace one = fixtures::expect_equal_on_ranks(plate(folder.path(), is_free, is_free ? 0.2 : 0));
    CHECK(one.contacts > 500);
    CHECK(one.broken_bonds > 0);
  }
}

TEST_CASE("restart: counts of detection work of an elastic impactor continue") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = plate(folder.path(), true, 0.2);
  Simulation first(setup), second(setup);
  for (int step = 0; step < 10; ++step) first.step();
  const ::fixtures::Snapshot snapshot(first);
  snapshot.give(second);
  CHECK(first.impactors()[0].effort(0).points_tested > 0);
  CHECK(second.impactors()[0].effort(0).points_tested == first.impactors()[0].effort(0).points_tested);
  CHECK(second.impactors()[0].effort(0).panels_tested == first.impactors()[0].effort(0).panels_tested);
}

TEST_CASE("ranks: an open elastic sheet remembers the particles in contact with it as on one rank") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = plate_below_sheet(folder.path());
  Simulation simulation(setup);
  while (!simulation.clock().is_finished()) simulation.step();
  std::size_t remembered = 0;
  simulation.visit_state([&](std::string_view name, auto&& values) {
    if (name == "cylinder.0.deforming.points_in_contact") remembered = fccda::numbers_in(values).size();
  });
  CHECK(remembered > 10);
  CHECK(fixtures::expect_equal_on_ranks(setup).broken_bonds > 0);
}
