// Several impactors on one body (docs/theory/contact.md, "Several impactors").
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::run;
using fixtures::value;

namespace {

/// A small block between the faces x = ±reach and y = ±reach of wide plates, each of which moves inward at `speed`.
Setup block_between(std::size_t plates, double speed) {
  Setup setup;
  setup.time = {.end = 5e-6, .step = 1e-7};  // at 2e-7 crushing by plates heavier than the block gains 6 % of energy
  BodySetup block = fixtures::body_setup({.size = {0.01, 0.01, 0.008}, .spacing = 0.002, .poissons_ratio = 0.25});
  block.name = "block";
  setup.bodies = {block};
  constexpr double reach = 0.005, thickness = 0.01;
  const Vec3d inward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (std::size_t k = 0; k < plates; ++k) {
    ImpactorSetup plate;
    plate.name = "plate_" + std::to_string(k);
    const Vec3d along{std::fabs(inward[k].x), std::fabs(inward[k].y), 0};
    plate.surface = BoxSurface{.size = {along.x > 0 ? thickness : 0.1, along.y > 0 ? thickness : 0.1, 0.1}, .edge_length = 0.01};
    plate.mass = 0.01;
    plate.position = -(reach + 0.5 * thickness + 1e-6) * inward[k];
    plate.velocity = speed * inward[k];
    plate.free_dofs = {"x", "y", "z"};
    setup.impactors.push_back(plate);
  }
  return setup;
}

}  // namespace

TEST_CASE("several impactors: a block in contact on three sides is outside all plates, without unresolved penetration, and momentum is conserved") {
  const Setup setup = block_between(3, 5);
  Simulation simulation(setup);
  const double before = value(simulation, "total.momentum_y [kg m/s]");
  CHECK(before == fixtures::relative(0.05, 1e-12));  // 10 g at 5 m/s
  for (int step = 0; step < 20; ++step) simulation.step();
  CHECK(simulation.contacts() > 0);
  const Body& block = simulation.bodies()[0];
  for (const std::uint32_t slot : block.particles.slot_of())
    for (const Impactor& impactor : simulation.impactors()) {
      const Vec3d set_initial_state = impactor.body().pose().to_body(block.particles.position.at(slot));
      const Vec3d half = 0.5 * impactor.surface().report().bounds.size();
      const double distance = norm(max(Vec3d{std::fabs(set_initial_state.x), std::fabs(set_initial_state.y), std::fabs(set_initial_state.z)} - half, Vec3d{}));
      CHECK(distance > 0.001 - 1e-12);  // half a spacing, less offset and rounding
    }
  run(simulation);
  CHECK(std::fabs(value(simulation, "total.momentum_y [kg m/s]") / before - 1) <= 1e-10);
  for (const Impactor& impactor : simulation.impactors()) CHECK(impactor.unresolved(0).count == 0);
  CHECK(simulation.closing_warnings().empty());
}

TEST_CASE("several impactors: penetration that two plates cannot resolve is counted and reported at the end") {
  Setup setup = block_between(2, 0);
  setup.bodies[0] = fixtures::body_setup({.size = {0.002, 0.01, 0.008}, .spacing = 0.002, .poissons_ratio = 0.25});
  setup.bodies[0].name = "sheet";
  setup.impactors[0].position.x += 0.004, setup.impactors[1].position.x -= 0.004;
  for (std::size_t k = 0; k < 2; ++k) setup.impactors[k].velocity.x = k == 0 ? 10 : -10, setup.impactors[k].free_dofs = {};
  Simulation simulation(setup);
  run(simulation);
  const Impactor& first = simulation.impactors()[0];
  CHECK(first.unresolved(0).count > 0);
  CHECK(first.unresolved(0).first == fixtures::relative(2e-7, 1e-12));  // 1e-6 of play each, 1e-6 a step
  CHECK(simulation.contacts() == 2 * 5 * 4);                            // each particle by both plates, independent of the number of passes
  CHECK(simulation.impactors()[1].unresolved(0).count == 0);            // the last to act puts them out of itself
  const std::vector<std::string> warnings = simulation.closing_warnings();
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("Particles of body sheet were pinched between impactor plate_0 and others, first at t = 2e-07 s: summed over steps, " +
                         std::to_string(first.unresolved(0).count) + " penetrations remained") == 0);
}

TEST_CASE("several impactors: any number of threads ends in the bitwise identical state") {
  Setup setup = block_between(4, 8);
  setup.impactors[0].angular_velocity = {0, 0, 300};
  setup.impactors[0].free_dofs = {"x", "y", "z", "rx", "ry", "rz"};
  setup.contact.impactors.friction = 0.2;
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const fixtures::Threads with_several(threads);
    Simulation simulation(setup);
    run(simulation);
    hashes.push_back(simulation.state_hash());
  }
  CHECK(hashes[0] == hashes[1]);
  CHECK(hashes[0] == hashes[2]);
}
