// Scaled inertia: what it changes, and what it must not.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/floating_boxes.hpp"
#include "perimpact/fragments/fragments.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::ice;
using fixtures::middle;
using fixtures::sea;

namespace {

constexpr double side = 2;                                    // [m]
constexpr double hydrostatics = side / 2 - side * ice / sea;  // [m] z of the middle of a block of that height whose water is at 0

/// A block of ice at rest on water, `above` [m] its equilibrium.
Setup block(double above, double mass_scaling, double end) {
  Setup setup = fixtures::floating_box({side, side, side}, hydrostatics + above, fixtures::calm(), end, {.density = ice, .spacing = 0.5});
  setup.bodies[0].mass_scaling = mass_scaling;
  return setup;
}

/// A bar with one end fixed that moves at 1 m/s.
Setup bar(double density, double mass_scaling) {
  Setup setup;
  BodySetup body = fixtures::body_setup({.size = {0.8, 0.2, 0.2}, .spacing = 0.05});
  body.material = OrdinaryStateSetup{ElasticSetup{.youngs_modulus = 1e9, .poissons_ratio = 0.3, .density = density}};
  body.mass_scaling = mass_scaling;
  body.velocity = {1, 0, 0};
  body.particle_sets = {{"end", BoxSolid{.size = {0.11, 1, 1}}, {-0.4, 0, 0}, {}}};
  body.boundary_conditions = {{"grip", FixedSetup{.particle_set = "end"}}};
  setup.bodies = {body};
  setup.time = {.end = 2e-3};
  return setup;
}

}  // namespace

TEST_CASE("mass scaling: motion, automatic step and energies are those of a body of that many times the density, bit by bit") {
  Simulation scaled(bar(1000, 4)), dense(bar(4000, 1));
  CHECK(scaled.clock().dt == dense.clock().dt);
  fixtures::run(scaled), fixtures::run(dense);
  CHECK(scaled.state_hash() == dense.state_hash());
  CHECK(fixtures::value(scaled, "body.kinetic_energy [J]") == fixtures::value(dense, "body.kinetic_energy [J]"));
  CHECK(fixtures::value(scaled, "body.kinetic_energy [J]") > 1);
}

TEST_CASE("mass scaling: a block floats as deep as before, and oscillates with the root of the factor times its period") {
  constexpr double factor = 3;
  Simulation still(block(0, factor, 0.5));
  fixtures::run(still);
  CHECK(std::fabs(middle(still) - hydrostatics) < 0.005);  // [m]; layers settle on one another, as in floating.test.cpp

  const double period = 2 * std::numbers::pi * std::sqrt(factor * side * ice / (sea * fixtures::gravity));
  Simulation bobs(block(0.05, factor, 0.75 * period));
  double before = middle(bobs), now = before;
  while (now > hydrostatics && !bobs.clock().is_finished()) {
    bobs.step();
    before = std::exchange(now, middle(bobs));
  }
  REQUIRE(now <= hydrostatics);
  const double passed = bobs.clock().time() - bobs.clock().dt * (now - hydrostatics) / (now - before);  // [s]
  CHECK(passed == fixtures::relative(0.25 * period, 0.02));                                             // 1 % of the period in floating.test.cpp
}

TEST_CASE("mass scaling: reported masses are those of the material") {
  Simulation scaled(block(0, 3, 0.1));
  const Body& body = scaled.bodies()[0];
  const double mass = ice * side * side * side;
  CHECK(body.particles.total_mass() == fixtures::relative(mass, 1e-12));
  CHECK(Fragments(body.particles, body.family).all()[0].mass == fixtures::relative(mass, 1e-12));
  CHECK(body.particles.mass(body.particles.slot_of()[0]) == fixtures::relative(3 * ice * 0.125, 1e-12));
}
