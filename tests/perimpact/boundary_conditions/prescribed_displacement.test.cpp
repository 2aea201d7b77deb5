#include "perimpact/boundary_conditions/actions/prescribed_displacement.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/boundary_conditions/scene.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;
using fixtures::BoundedBody;

namespace {

constexpr double dt = 2e-7;  // [s] the safe step of this lattice is 1.8e-7·2

/// A bar along x; its ends are two layers thick.
BodySetup bar_setup() { return fixtures::body_setup({.size = {0.024, 0.006, 0.006}, .spacing = 0.001}); }

const fixtures::Regions ends = {{"left", [](const Vec3d& X) { return X.x < -0.01; }}, {"right", [](const Vec3d& X) { return X.x > 0.01; }}};

DisplacementSetup displaced(std::vector<double> times, std::vector<double> displacements) {
  DisplacementSetup course;
  course.times = std::move(times), course.displacements = std::move(displacements);
  return course;
}

DisplacementSetup at_velocity(double velocity) {
  DisplacementSetup course;
  course.velocity = velocity;
  return course;
}

}  // namespace

TEST_CASE("prescribed displacement: at the end of every step positions equal the table bitwise, and velocities its slope") {
  BodySetup setup = bar_setup();
  // kinks between steps and at one, and times after the last point
  setup.boundary_conditions = {{"pull", PrescribedSetup{.particle_set = "right", .x = displaced({0, 3.3e-6, 6e-6}, {0, 2e-6, -1e-6}), .y = at_velocity(0.5)}},
                               {"grip", FixedSetup{.particle_set = "left", .directions = {"x", "z"}}}};
  BoundedBody scene(setup, ends, dt);
  const fccda::PiecewiseLinear table({0, 3.3e-6, 6e-6}, {0, 2e-6, -1e-6});
  std::size_t wrong = 0, moved_freely = 0;
  for (int step = 0; step < 40; ++step) {
    scene.step();
    const fccda::Step latest = scene.clock.latest();
    for (const std::uint32_t slot : scene.body.particles.slot_of()) {
      const Vec3d X = scene.body.particles.reference(slot), x = scene.body.particles.position.at(slot), v = scene.body.particles.velocity.at(slot);
      if (X.x > 0.01) wrong += x.x != X.x + table.at(latest.t1) || v.x != table.slope(latest.t0, latest.t1) || x.y != X.y + 0.5 * latest.t1 || v.y != 0.5;
      if (X.x < -0.01) wrong += x.x != X.x || v.x != 0 || x.z != X.z || v.z != 0;
      if (X.x < -0.01) moved_freely += x.y != X.y;
    }
  }
  CHECK(wrong == 0);
  CHECK(moved_freely > 0);  // y of the grip is free
}

TEST_CASE("prescribed displacement: particles gain the impulse of the reactions in momentum and their work in energy") {
  BodySetup setup = bar_setup();
  setup.velocity = {3, -1, 2};
  setup.boundary_conditions = {{"pull", PrescribedSetup{.particle_set = "right", .x = displaced({0, 4e-6, 8e-6}, {0, 4e-6, 0})}},
                               {"grip", FixedSetup{.particle_set = "left", .directions = {}}}};
  BoundedBody scene(setup, ends, dt);
  const Vec3d before = scene.body.motion().momentum;
  const double energy_before = scene.energy() - scene.boundary_conditions.work();
  Vec3d impulse{};
  double largest_work = 0;
  for (int step = 0; step < 60; ++step) {
    scene.step();
    largest_work = fixtures::larger(largest_work, std::fabs(scene.boundary_conditions.work()));
  }
  for (const NamedBoundaryCondition& one : scene.boundary_conditions.all()) impulse += one.account().impulse();
  // The two are sums of the same products in another order: rounding of 60 steps and a thousand particles.
  CHECK(norm(scene.body.motion().momentum - before - impulse) <= 1e-12 * norm(before));
  CHECK(norm(impulse) > 0.1 * norm(before));
  // Interpolated kinetic energy ripples by (ω dt)² of the energy in the shortest waves, which the sudden stop of the grip excites: 1.4 % here,
  // and a quarter of that with half the step.
  CHECK(std::fabs(scene.energy() - energy_before - scene.boundary_conditions.work()) <= 0.03 * largest_work);
}

TEST_CASE("prescribed displacement: the work of slow tension is the elastic energy, half of force times displacement") {
  BodySetup setup = bar_setup();
  setup.boundary_conditions = {{"grip", FixedSetup{.particle_set = "left", .directions = {"x"}}},
                               {"pull", PrescribedSetup{.particle_set = "right", .x = displaced({0, 300e-6}, {0, 1e-6})}}};
  BoundedBody scene(setup, ends, dt);
  for (int step = 0; step < 1500; ++step) scene.step();
  const double work = scene.boundary_conditions.work();
  // The pull takes sixty times as long as a wave along the bar. Its force climbs in stairs, by 1/30 at each return of the wave, which overshoots on a
  // lattice: the last one is 3.5 % off the straight line. The energy in motion is (1/60)² of the elastic one.
  CHECK(work == fixtures::relative(scene.elastic_energy, 1e-3));
  CHECK(work == fixtures::relative(0.5 * scene.boundary_conditions.all()[1].account().force().x * 1e-6, 0.05));
}

TEST_CASE("prescribed displacement: constraining a direction twice is refused, other directions are not") {
  BodySetup setup = bar_setup();
  setup.boundary_conditions = {{"grip", FixedSetup{.particle_set = "left", .directions = {"x", "y"}}},
                               {"guide", PrescribedSetup{.particle_set = "left", .z = at_velocity(1)}}};
  BoundedBody(setup, ends, dt);
  setup.boundary_conditions.push_back({"all", PrescribedSetup{.y = at_velocity(1)}});
  std::string key, sentence;
  try {
    BoundedBody(setup, ends, dt);
  } catch (const SetupError& error) {
    key = error.key(), sentence = error.what();
  }
  CHECK(key == "bodies.body.boundary_conditions.all");
  CHECK(sentence ==
        "all constrains particles of body body in direction y that grip constrains too; separate their particle sets, or remove the direction from one of the "
        "two.");
}
