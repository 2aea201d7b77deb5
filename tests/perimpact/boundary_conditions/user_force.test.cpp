#include "perimpact/boundary_conditions/actions/user_force.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

/// A block of 8 × 5 × 4 particles that moves along x at 1 m/s, unless it is plane.
Setup block(bool is_plane = false) {
  BodySetup body{.name = "block"};
  body.shape = BoxSolid{{0.08, 0.05, 0.04}};
  body.spacing = 0.01;
  OrdinaryStateSetup material;
  material.youngs_modulus = 1e9, material.density = 1000;
  if (is_plane) material.poissons_ratio = 1.0 / 3, body.plane.index = static_cast<int>(Plane::stress);
  body.material = material;
  body.velocity = {1, 0, 0};
  Setup setup;
  setup.time = {.end = 1e-3, .step = 5e-6};
  setup.bodies = {body};
  return setup;
}

UserForceOnBody given(std::function<void(double, const Body&, VectorArray&)> function) { return {0, "own", std::move(function)}; }

Simulation made(const Setup& setup, std::function<void(double, const Body&, VectorArray&)> function) {
  return Simulation(setup, Start(setup), {given(std::move(function))});
}

}  // namespace

TEST_CASE("user force: it is evaluated at t = 0 and once per step, on a force density of zero") {
  std::vector<double> times;
  std::size_t changed_before = 0;
  Simulation simulation = made(block(), [&](double time, const Body& body, VectorArray& density) {
    times.push_back(time);
    for (std::size_t slot = 0; slot < body.particles.slots(); ++slot) changed_before += density.at(slot) == Vec3d{} ? 0 : 1;
    for (const std::uint32_t slot : body.particles.slot_of()) density.set(slot, {0, 0, 1});
  });
  fixtures::run(simulation);
  REQUIRE(times.size() == static_cast<std::size_t>(simulation.clock().steps) + 1);
  for (std::size_t n = 0; n < times.size(); ++n) CHECK(times[n] == static_cast<double>(n) * simulation.clock().dt);
  CHECK(changed_before == 0);
}

TEST_CASE("user force: one that makes the energy overflow ends the run at the next row, with the last valid step") {
  Setup setup = block();
  setup.output.history_interval = setup.time.end / 20;
  Simulation simulation = made(setup, [&](double time, const Body& body, VectorArray& density) {
    if (time > 0.3 * setup.time.end) density.set(body.particles.slot_of()[5], {0, 1e300, 0});
  });
  std::string sentence;
  try {
    fixtures::run(simulation);
  } catch (const fccda::RunError& error) {
    sentence = error.what();
  }
  CAPTURE(sentence);
  CHECK(sentence.find(" not a number. Output up to step ") != std::string::npos);
  CHECK(sentence.ends_with(" is valid; use a smaller time step."));
  CHECK(simulation.clock().time() < 0.4 * setup.time.end);
}

TEST_CASE("user force: its work is the kinetic energy that it removes from a body it brakes") {
  Simulation simulation = made(block(), [](double, const Body& body, VectorArray& density) {
    for (const std::uint32_t slot : body.particles.slot_of()) density.set(slot, {-5e5, 0, 0});  // half of the velocity in the run
  });
  const double mass = 1000 * 0.08 * 0.05 * 0.04;
  fixtures::run(simulation);
  const double n = static_cast<double>(simulation.clock().steps), dt = simulation.clock().dt;
  // work = F Σ v_{k-1/2} dt with v_{k-1/2} = v - k a dt
  const double way = n * dt * 1.0 - 500 * dt * dt * n * (n + 1) / 2;
  CHECK(fixtures::value(simulation, "block.own.work [J]") == fixtures::relative(-500 * mass * way, 1e-10));  // 160 particles, 200 steps
  CHECK(fixtures::value(simulation, "block.own.force_x [N]") == fixtures::relative(-500 * mass, 1e-10));
  CHECK(std::fabs(fixtures::value(simulation, "total.energy_balance_error [J]")) < 1e-10 * 0.5 * mass);
}

TEST_CASE("user force: values that are not finite, out-of-plane components and duplicate names are refused") {
  const auto constant = [](const Vec3d& f) {
    return [f](double, const Body& body, VectorArray& density) {
      for (const std::uint32_t slot : body.particles.slot_of()) density.set(slot, f);
    };
  };
  CHECK_THROWS_WITH_AS(made(block(), constant({std::nan(""), 0, 0})),
                       "At 0 s the user force block.own is not finite on 160 particles; check the function that computes it.", fccda::RunError);
  CHECK_THROWS_WITH_AS(made(block(true), constant({0, 0, 1})),
                       "the user force block.own acts along z on 40 particles, but the body is 2-D; set its z component to 0.", fccda::InputError);
  const Setup setup = block();
  CHECK_THROWS_WITH_AS(Simulation(setup, Start(setup), {given(constant({})), given(constant({}))}),
                       "block.own is already the name of a boundary condition, whose columns in history.csv it would share; choose another.", SetupError);
}
