#include "perimpact/simulation/start.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
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

/// A block with a ball sunk into its upper face; the ball rests unless it is given a velocity.
Setup sunk_ball(InitialOverlap choice) {
  Setup setup;
  setup.time = {.end = 10e-6, .step = 2e-7};
  BodySetup block = fixtures::body_setup({.size = {0.032, 0.02, 0.02}, .spacing = 0.002});
  block.name = "block";
  setup.bodies = {block};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.012, .edge_length = 0.001};
  ball.mass = 0.01;
  ball.position = {0.001, 0.012, 0};
  ball.free_dofs = {"x", "y", "z"};
  setup.impactors = {ball};
  setup.contact.impactors.initial_overlap.index = static_cast<int>(choice);
  setup.output.history_interval = 2e-6;
  return setup;
}

/// Particles within that radius of the ball's centre, from the coordinates alone.
std::size_t particles_within(double radius) {
  std::size_t count = 0;
  for (double x = -0.015; x < 0.016; x += 0.002)
    for (double y = -0.009; y < 0.01; y += 0.002)
      for (double z = -0.009; z < 0.01; z += 0.002)
        if (norm(Vec3d{x - 0.001, y - 0.012, z}) < radius) ++count;
  return count;
}

bool warns_of(const Simulation& simulation, const std::string& words) {
  return std::any_of(simulation.warnings().begin(), simulation.warnings().end(), [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

}  // namespace

TEST_CASE("start: initial penetration is an error by default, which names the two remedies") {
  const std::string sentence = complaint(sunk_ball(InitialOverlap::error));
  CHECK(sentence.find("impactors.ball.position: impactor ball starts inside body block: ") == 0);
  CHECK(sentence.find("contact.impactors.initial_overlap: remove or project.") != std::string::npos);
}

TEST_CASE("start: with removed particles the body is at rest with a hole, whose bonds are gone and beside which it is corrected as at a surface") {
  Simulation simulation(sunk_ball(InitialOverlap::remove));
  REQUIRE(simulation.initial_penetrations().size() == 1);
  const std::size_t removed = simulation.initial_penetrations()[0].slots.size();
  // within R + Δ/2 of the centre; the faceted ball lies up to Δm²/(8R) < 0.03 mm inside the round one
  CHECK(removed >= particles_within(0.007 - 3e-5));
  CHECK(removed <= particles_within(0.007));
  const Body& block = simulation.bodies()[0];
  CHECK(block.particles.size() == 16 * 10 * 10 - removed);
  CHECK(warns_of(simulation, std::to_string(removed) + " particles that were inside its surface, or nearer to it than the contact radius, were removed"));

  // every particle beside the hole is stiffened as one at a surface is: a particle that keeps all its neighbours has the factor 1
  const Body hole_free = make_body(sunk_ball(InitialOverlap::remove).bodies[0]);
  std::size_t stiffened = 0, ends = 0;
  const std::span<const std::uint32_t> kept = block.particles.slot_of();
  for (const std::uint32_t slot : kept)
    hole_free.family.for_each_bond(slot, [&](const FamilyBond& bond) { ends += static_cast<std::size_t>(std::ranges::count(kept, bond.j)); });
  CHECK(block.family.initial_bonds() == ends / 2);
  for (const std::uint32_t slot : block.particles.slot_of())
    if (norm(block.internal.ordinary_state()->correction().stretch().at(slot) - hole_free.internal.ordinary_state()->correction().stretch().at(slot)) > 0.01)
      ++stiffened;
  CHECK(stiffened > 20);

  while (!simulation.clock().is_finished()) {
    CHECK(value(simulation, "ball.force_y [N]") == 0);
    simulation.step();
  }
  CHECK(value(simulation, "total.energy [J]") < 1e-12);  // rounding of coordinates, far below a nanometre of strain
}

TEST_CASE("start: projected particles start on the surface with their velocity and without contact force, and a warning gives the strain of their bonds") {
  Setup setup = sunk_ball(InitialOverlap::project);
  setup.bodies[0].velocity = {0, 1, 0};
  Simulation simulation(setup);
  REQUIRE(simulation.initial_penetrations().size() == 1);
  const InitialPenetration& inside = simulation.initial_penetrations()[0];
  const Body& block = simulation.bodies()[0];
  CHECK(block.particles.size() == 16 * 10 * 10);
  CHECK(block.family.initial_bonds() == make_body(setup.bodies[0]).family.initial_bonds());
  double furthest = 0;
  for (const std::size_t slot : inside.slots) {
    // at R + Δ/2 from the centre; facets lie up to 0.03 mm below the sphere
    CHECK(norm(block.particles.position.at(slot) - Vec3d{0.001, 0.012, 0}) == fixtures::absolute(0.007, 3e-5, "m"));
    CHECK(block.particles.velocity.at(slot) == Vec3d{0, 1, 0});
    furthest = fixtures::larger(furthest, norm(block.particles.displacement(slot)));
  }
  CHECK(inside.furthest == furthest);
  CHECK(furthest > 0.001);
  CHECK(value(simulation, "ball.force_y [N]") == 0);
  CHECK(value(simulation, "ball.velocity_y [m/s]") == 0);
  CHECK(value(simulation, "total.momentum_y [kg m/s]") == fixtures::relative(block.particles.mass(0) * 1600, 1e-12));
  CHECK(value(simulation, "block.elastic_energy [J]") > 0);
  CHECK(simulation.contacts() == 0);
  CHECK(warns_of(simulation, "were projected onto it, by at most "));

  double stretch = 0;  // over all pairs, from positions alone
  const auto& slots = block.particles.slot_of();
  for (const std::uint32_t i : slots)
    for (const std::uint32_t j : slots) {
      const double length = norm(block.particles.reference(i) - block.particles.reference(j));
      if (i == j || length > 3.515 * 0.002) continue;  // hu-ha-bobaru: |ξ| < δ + Δ/2
      stretch = fixtures::larger(stretch, std::fabs(norm(block.particles.position.at(i) - block.particles.position.at(j)) / length - 1));
    }
  CHECK(largest_stretch(block, inside.slots) == fixtures::relative(stretch, 1e-12));
}

TEST_CASE("start: after projection out of two overlapping balls, no particle is inside either") {
  Setup setup = sunk_ball(InitialOverlap::project);
  setup.impactors.push_back(setup.impactors[0]);
  setup.impactors[1].name = "second";
  setup.impactors[1].position = {0.006, 0.012, 0};
  Start start(setup);
  for (const InitialPenetration& inside : start.inside) CHECK(inside.slots.size() > 10);
  CHECK(start.inside.size() == 2);
  for (const Impactor& impactor : start.impactors)
    CHECK(impactor.initial_overlap(0, ContactParticles(start.particles[0], setup.contact.impactors, {}, 0)).empty());
}

TEST_CASE("start: an impactor that contains the whole body leaves no particles to keep, and particles between two faces cannot be projected") {
  Setup setup = sunk_ball(InitialOverlap::remove);
  setup.impactors[0].surface = BoxSurface{.size = {0.1, 0.1, 0.1}, .edge_length = 0.1};
  CHECK(complaint(setup).find("leaves nothing of it") != std::string::npos);

  setup = sunk_ball(InitialOverlap::project);
  setup.impactors[0].surface = BoxSurface{.size = {0.1, 0.02, 0.1}, .edge_length = 0.1};
  setup.impactors[0].position = {0, 0.0101, 0};  // upper half of the block
  setup.impactors.push_back(setup.impactors[0]);
  setup.impactors[1].name = "second";
  setup.impactors[1].position = {0, -0.0099, 0};  // lower half, half a millimetre further in than there is room
  CHECK(complaint(setup).find("no position near them is outside all impactors") != std::string::npos);
}

TEST_CASE("start: a moving body is evaluated at its position at t = 0, not a step before") {
  Setup setup = sunk_ball(InitialOverlap::error);
  setup.impactors[0].position = {0.001, 0.0161, 0};  // 0.1 mm clear of contact
  setup.bodies[0].velocity = {0, -2000, 0};          // 0.4 mm a step
  CHECK(complaint(setup).empty());
}
