#include "perimpact/boundary_conditions/absorbing/absorbing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/tolerance.hpp"
#include "perimpact/boundary_conditions/scene.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

using namespace perimpact;
using fixtures::BoundedBody;

namespace {

constexpr double dt = 1.5e-7;     // [s]
constexpr double length = 0.16;   // [m] of the bar along x
constexpr double inner = 0.02;    // [m] where the layer begins, 0.06 m from its end
constexpr double middle = -0.02;  // [m] where the pulse begins

struct Echo {
  double energy;    ///< [-] that is left when the pulse is back where it began, of what there was
  double absorbed;  ///< [-] what the layer says it took, of the same
};

/// A pulse along a bar in uniaxial strain (constrained sides) into the layer and back.
Echo echo(std::optional<double> reflection) {
  BodySetup setup = fixtures::body_setup({.size = {length, 0.004, 0.004}});
  setup.boundary_conditions = {{"sides", FixedSetup{.directions = {"y", "z"}}}};
  if (reflection)
    setup.boundary_conditions.push_back({"sink", AbsorbingSetup{.particle_set = "layer", .face = Choice{face_words, 0}, .reflection = *reflection}});
  BoundedBody scene(setup, {{"layer", [](const Vec3d& X) { return X.x > inner; }}}, dt);
  const double speed = std::sqrt(IsotropicElastic{fixtures::youngs_modulus, 0.25}.p_wave_modulus() / fixtures::density);
  for (const std::uint32_t slot : scene.body.particles.slot_of()) {
    const Vec3d X = scene.body.particles.reference(slot);
    constexpr double width = 0.006, height = 1e-6;  // [m]
    const double away = (X.x - middle) / width, u = height * std::exp(-away * away);
    scene.body.particles.position.set(slot, X + Vec3d{u, 0, 0});
    scene.body.particles.velocity.set(slot, {speed * 2 * away / width * u, 0, 0});
  }
  scene.evaluate();
  const double before = scene.energy(), work_before = scene.boundary_conditions.work();
  while (scene.clock.time() < 2 * (0.5 * length - middle) / speed) scene.step();
  return {scene.energy() / before, (work_before - scene.boundary_conditions.work()) / before};
}

}  // namespace

TEST_CASE("absorbing: the reflection coefficient is the requested one, and the layer accounts for the missing energy") {
  for (const double reflection : {0.5, 0.2}) {
    const Echo result = echo(reflection);
    CAPTURE(reflection);
    // the lattice's wave is a few parts in a hundred slower than the solid's, and R^(c/c_lattice) differs from R by that share of ln R
    CHECK(std::sqrt(result.energy) == fixtures::relative(reflection, 0.05));
    // 0.6 % at this step, falling with its square: forces and velocities of a leapfrog belong to different instants
    CHECK(result.energy + result.absorbed == fixtures::relative(1, 0.01));
  }
  CHECK(echo({}).energy == fixtures::relative(1, 1e-3));
}

TEST_CASE("absorbing: damping increases with the square of the depth to 3 c ln(1/R)/L, with the integral of the formula") {
  CHECK(layer_damping(0, 2, 5000, 0.01) == 0);
  CHECK(layer_damping(2, 2, 5000, 0.01) == fixtures::relative(3 * 5000 * std::log(100) / 2, 1e-14));
  double integral = 0;  // of α/(2c), inward and outward, by the midpoint rule
  constexpr int pieces = 1000;
  for (int k = 0; k < pieces; ++k) integral += 2 * layer_damping((k + 0.5) / pieces * 2, 2, 5000, 0.01) / (2 * 5000) * 2 / pieces;
  CHECK(std::exp(-integral) == fixtures::relative(0.01, 1e-5));  // the rule's error is 1/pieces²
}

TEST_CASE("absorbing: velocities decay by (1 - α dt/2)/(1 + α dt/2) per step for any damping, so that it does not limit the time step") {
  Body body = make_body(fixtures::body_setup({.size = {0.004, 0.004, 0.004}}));
  for (const std::uint32_t slot : body.particles.slot_of()) body.particles.velocity.set(slot, {3, 0, 0});
  const std::vector<std::uint32_t> slots(body.particles.slot_of().begin(), body.particles.slot_of().end());
  Absorbing layer(slots, std::vector<double>(slots.size(), 10 / dt));
  layer.damp(body.particles, dt);
  const double before = body.motion(dt).kinetic_energy_of_scheme, work_before = layer.account.work();
  std::vector<double> travel(travel_blocks(body.particles));
  advance(body.particles, dt, travel);
  for (const std::uint32_t slot : slots) CHECK(body.particles.velocity.at(slot).x == fixtures::relative(3 * (1. - 5) / (1 + 5), 1e-14));  // rounding

  for (const std::uint32_t slot : slots) body.particles.force_density.set(slot, {});
  layer.damp(body.particles, dt);
  const double kinetic = 0.5 * body.particles.total_mass() * 9;  // [J] at first
  // rounding of sums over 64 particles
  CHECK(std::fabs(body.motion(dt).kinetic_energy_of_scheme - before - (layer.account.work() - work_before)) < 1e-12 * kinetic);
}

TEST_CASE("absorbing: constrained directions are not damped") {
  BodySetup setup = fixtures::body_setup({.size = {0.01, 0.004, 0.004}});
  setup.boundary_conditions = {{"sink", AbsorbingSetup{.particle_set = "right", .face = Choice{face_words, 0}}},
                               {"end", FixedSetup{.particle_set = "last", .directions = {"x"}}}};
  const Body body = make_body(setup);
  const BoundaryConditions boundary_conditions(
      setup, elastic_of(setup), body.particles,
      fixtures::slots_of(body.particles, {{"right", [](const Vec3d& X) { return X.x > 0; }}, {"last", [](const Vec3d& X) { return X.x > 0.004; }}}));
  const Absorbing& layer = std::get<Absorbing>(boundary_conditions.all()[0].boundary);
  const auto free = [&](std::size_t axis) {
    int count = 0;
    for (std::size_t k = 0; k < layer.slots().size(); ++k) count += layer.damping(k)[axis] > 0 ? 1 : 0;
    return count;
  };
  CHECK(free(0) == 4 * 4 * 4);  // of five layers the last is constrained
  CHECK(free(1) == 5 * 4 * 4);
}
