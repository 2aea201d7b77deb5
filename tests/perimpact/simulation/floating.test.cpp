// Bodies that float: weight, buoyancy, drag and added mass in whole simulations, against the hydrostatics of rigid bodies.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/boundary_conditions/floating/floating.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/floating_boxes.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::calm;
using fixtures::complaint;
using fixtures::gravity;
using fixtures::ice;
using fixtures::middle;
using fixtures::sea;
using fixtures::value;

namespace {

constexpr double side = 2, spacing = 0.5;                     // [m]
constexpr double hydrostatics = side / 2 - side * ice / sea;  // [m] z of the middle of a block of that height whose water is at 0

/// A block of soft ice with its middle at z.
Setup block(double z, const FloatingSetup& water, double end, double density = ice) {
  return fixtures::floating_box({side, side, side}, z, water, end, {.density = density, .spacing = spacing});
}

/// [s] between the first and the last upward crossing of z by the centre, over the number of oscillations between.
double period(Simulation& simulation, double z) {
  std::vector<double> times;
  double before = middle(simulation);
  while (!simulation.clock().is_finished()) {
    simulation.step();
    const double now = middle(simulation);
    if (before < z && now >= z) times.push_back(simulation.clock().time() - simulation.clock().dt * (now - z) / (now - before));
    before = now;
  }
  REQUIRE(times.size() >= 2);
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

}  // namespace

TEST_CASE("floating: while the level is inside a sheet, its columns are Winkler springs of the modulus ρ g, for any number of layers") {
  for (const double layer : {2.0, 1.0, 0.5, 0.25}) {
    const Body body = fixtures::body({.size = {2, 2, 2}, .spacing = layer});
    const std::vector<std::uint32_t> slots(body.particles.slot_of().begin(), body.particles.slot_of().end());
    for (const double level : {-0.99, -0.7, 0.0, 0.33, 1.0}) {
      Particles particles = body.particles;
      particles.force_density = VectorArray(particles.slots(), 0);
      Floating water(body.particles, slots, {.level = level, .density = sea, .gravity = gravity, .drag = 0, .added_mass = 0, .damping = 0}, level);
      const double lift = sea * gravity * 4 * (level + 1), weight = fixtures::density * gravity * 8;
      CHECK(water.static_hydrostatics(particles).force.z == fixtures::relative(lift - weight, 1e-13));  // rounding of 512 particles
    }
  }
}

TEST_CASE("floating: the equilibrium level is that of Archimedes, exact for a box, to the lattice for a sphere, and none for iron") {
  Simulation box(block(0.4, {.density = sea, .gravity = gravity}, 0.1));
  const auto& water = std::get<Floating>(box.boundary_conditions()[0].all()[0].boundary);
  CHECK(water.water().level == fixtures::relative(0.4 - hydrostatics, 1e-12));
  CHECK(water.floats_at() == fixtures::relative(water.water().level, 1e-12));

  Setup setup = block(0, {.density = 2 * ice, .gravity = gravity}, 0.1);
  setup.bodies[0].shape = SphereSolid{.diameter = 4};
  setup.bodies[0].spacing = 0.2;
  Simulation sphere(setup);
  CHECK(std::fabs(std::get<Floating>(sphere.boundary_conditions()[0].all()[0].boundary).water().level) < 1e-12);  // of half the density: to its middle

  std::string key;
  const std::string sentence = complaint(block(0, {.density = sea}, 0.1, 7800), key);
  CHECK(key == "bodies.ice.boundary_conditions.sea.floating");
  CHECK(sentence.find("body ice of 7800 kg/m3 sinks in water of 1025 kg/m3") != std::string::npos);
}

TEST_CASE("floating: a block in equilibrium stays there, and one released from another position oscillates with the period of its hydrostatic stiffness") {
  Simulation still(block(hydrostatics, calm(), 0.5));
  while (!still.clock().is_finished()) still.step();
  // layers settle on one another by ρ g H²/(2 E) = 9 mm of 2 m at this modulus; of the middle a quarter of that, both ways
  CHECK(std::fabs(middle(still) - hydrostatics) < 0.005);

  Simulation bobs(block(hydrostatics + 0.05, calm(), 8));
  const double expected = 2 * std::numbers::pi * std::sqrt(side * ice / (sea * gravity));
  // 1 %: the block's own springs, ω² of its first mode being 400 times that of the bob, and a step of its period/1000
  CHECK(period(bobs, hydrostatics) == fixtures::relative(expected, 0.01));
}

TEST_CASE("floating: added mass reduces the frequency by the root of one plus its coefficient") {
  FloatingSetup water = calm();
  water.added_mass = 0.8;
  Simulation bobs(block(hydrostatics + 0.05, water, 10));
  const double expected = 2 * std::numbers::pi * std::sqrt(side * ice / (sea * gravity)) * std::sqrt(1.8);
  CHECK(period(bobs, hydrostatics) == fixtures::relative(expected, 0.01));  // as above
}

TEST_CASE("floating: a heavy block sinks at the speed at which drag on its surface particles balances its submerged weight") {
  constexpr double heavy = 2000;
  FloatingSetup water = calm();
  water.drag = 1.2;
  Setup setup = block(-5, water, 4, heavy);
  setup.bodies[0].velocity = {0, 0, -3};
  Simulation sinks(setup);
  while (!sinks.clock().is_finished()) sinks.step();
  constexpr double outside = 4 * 4 * 4 - 2 * 2 * 2;  // particles of the surface
  const double expected = std::sqrt((heavy - sea) * gravity * side * side * side / (0.5 * sea * 1.2 * outside * spacing * spacing));
  double speed = 0;
  for (const std::uint32_t slot : sinks.bodies()[0].particles.slot_of()) speed -= sinks.bodies()[0].particles.velocity.at(slot).z / 64;
  // from 3 m/s it comes within e⁻⁸ in 4 s; the rest is the shaking of its springs
  CHECK(speed == fixtures::relative(expected, 0.005));
}

TEST_CASE("floating: the work of weight, buoyancy, drag, damping and added mass is that of the boundary condition, and their impulse the change of momentum") {
  FloatingSetup water = calm();
  water.drag = 1, water.damping = 0.3, water.added_mass = 0.5;
  Simulation splash(block(1.5, water, 3));
  const auto [impulse, largest, off] = fixtures::run_in_water(splash);
  const double fall = ice * side * side * side * gravity * (1.5 - side / 2);
  CHECK(largest > 0.8 * fall);   // it fell freely till it met the water; damping takes some
  CHECK(off < 0.005 * largest);  // second order in the step but where the level passes the corners of S
  CHECK(value(splash, "total.momentum_z [kg m/s]") == fixtures::relative(impulse, 1e-9));  // it began at rest
}

TEST_CASE("floating: relaxation of a block converges to the level of Archimedes, from above and from below") {
  for (const double away : {0.15, -0.1}) {
    Setup setup = block(hydrostatics + away, calm(), 1);
    setup.time.relax = RelaxSetup{.increments = 1, .tolerance = 1e-6};
    setup.output.history_interval.reset();
    Simulation simulation(setup);
    while (!simulation.clock().is_finished()) simulation.step();
    CHECK(std::fabs(middle(simulation) - hydrostatics) < 0.005);  // the layers' own settlement, as above
  }
}

TEST_CASE("floating: two floating boundary conditions on the same particles are refused") {
  Setup setup = block(0, calm(), 0.1);
  setup.bodies[0].boundary_conditions.push_back({"lake", calm()});
  std::string key;
  const std::string sentence = complaint(setup, key);
  CHECK(key == "bodies.ice.boundary_conditions.lake");
  CHECK(sentence.starts_with("lake applies weight and buoyancy to particles of body ice that another floating boundary condition includes"));
}

TEST_CASE("floating: constrained particles neither drag nor sink, and their reaction supports them") {
  Setup setup = block(hydrostatics + 0.3, calm(), 0.2);
  FloatingSetup& water = std::get<FloatingSetup>(setup.bodies[0].boundary_conditions[0].kind);
  water.damping = 2, water.drag = 1;
  setup.bodies[0].boundary_conditions.push_back({"crane", FixedSetup{}});
  Simulation held(setup);
  while (!held.clock().is_finished()) held.step();
  CHECK(middle(held) == fixtures::relative(hydrostatics + 0.3, 1e-14));
  CHECK(value(held, "ice.sea.work [J]") == fixtures::absolute(0, 1e-9, "J"));
  const double out_of_water = sea * gravity * side * side * 0.3;
  CHECK(value(held, "ice.crane.force_z [N]") == fixtures::relative(out_of_water, 1e-9));
}
