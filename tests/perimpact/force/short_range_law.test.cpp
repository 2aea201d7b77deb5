#include "perimpact/force/short_range_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "fccda/core/parallel.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/force/piles.hpp"

using namespace perimpact;

namespace {

/// Speed of parting over speed of approach of a linear oscillator that ends when nothing pushes any more, in steps so small that they do not show.
double integrated_restitution(double damping_ratio) {
  const double dt = 1e-5;  // of 1/ω
  double x = 0, v = 1;     // overlap and its rate
  while (true) {
    const double force = x + 2 * damping_ratio * v;
    if (force <= 0) return -v;
    v -= force * dt;
    x += v * dt;
  }
}

/// Two particles fly at one another with 1 m/s each; returns how fast they part, over 2 m/s. `steps` in one radian of the contact.
double restitution_of_two(double wanted, double steps) {
  const double size = 0.001;
  fixtures::Pile pile{.law = {.damping_ratio = damping_ratio_of(wanted)}, .bodies = {}};
  pile.bodies.push_back(fixtures::lone_particle(size, {-0.55 * size, 0, 0}, {1, 0, 0}));
  pile.bodies.push_back(fixtures::lone_particle(size, {0.55 * size, 0, 0}, {-1, 0, 0}));
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  const double mass = pile.bodies[0].particles.mass(pile.bodies[0].particles.slot_of()[0]), volume = size * size * size;
  const double dt = 1 / steps / std::sqrt(bodies[0].stiffness * volume * volume / (0.5 * mass));
  std::vector<double> travel(1);
  const int threads = fccda::thread_count();
  fccda::use_threads(1);  // two particles are not worth waking another
  bool touched = false;
  double energy = 0;
  for (int step = 0; step < 100000; ++step) {
    for (Body& body : pile.bodies) advance(body.particles, dt, travel);
    pile.clear_forces();
    contact.add_forces(bodies, dt);
    contact.note_work(bodies, dt);
    touched = touched || contact.touching() > 0;
    energy = std::max(energy, contact.energy());
    if (touched && contact.touching() == 0) break;
  }
  fccda::use_threads(threads);
  REQUIRE(touched);
  if (wanted == 1) CHECK(energy == fixtures::relative(mass, 0.01));  // 2 m v²/2 all in the spring, but for where in a step its end falls
  const double parting = pile.bodies[1].particles.velocity.at(0).x - pile.bodies[0].particles.velocity.at(0).x;
  // what the dashpot took is what is missing
  CHECK(mass * (1 - 0.25 * parting * parting) == fixtures::absolute(contact.restitution_work(), 0.01 * mass, "J"));
  return parting / 2;
}

}  // namespace

TEST_CASE("short-range law: the damping ratio gives the restitution asked for, from weak to overdamped") {
  CHECK(damping_ratio_of(1) == 0);
  for (const double e : {0.95, 0.8, 0.5, 0.2, std::exp(-2.0), 0.1}) {
    CAPTURE(e);
    CHECK(integrated_restitution(damping_ratio_of(e)) == fixtures::relative(e, 1e-3));  // first order in the step of 1e-5, over a few radians
  }
  CHECK(damping_ratio_of(std::exp(-2.0)) == fixtures::relative(1, 1e-6));  // where the two branches meet
}

TEST_CASE("short-range law: two particles that collide part with the restitution of the deck, and the dashpots' work is the energy they lack") {
  for (const double e : {1.0, 0.9, 0.5, 0.2}) {
    CAPTURE(e);
    CHECK(restitution_of_two(e, 200) == fixtures::relative(e, 0.02));  // velocities are half a step old: 2 ζ/200 of a radian, and the end of contact
  }
}

TEST_CASE("short-range law: friction is Coulomb's when fast, in proportion to speed when slow, and never turns sliding round") {
  const ShortRangeLaw law{.friction = 0.3, .friction_speed = 0.01};
  Touch touch{.overlap = 1e-6, .direction = {1, 0, 0}, .velocity = {5, 0, -20}, .stiffness = 1e9, .reduced_mass = 1e-3};
  const double normal = 1e3;
  CHECK(force_of(touch, law, 1e-9).friction == Vec3d{0, 0, -0.3 * normal});  // on i, along with j
  touch.velocity.z = 0.001;                                                  // a tenth of the speed below which it fades
  CHECK(force_of(touch, law, 1e-9).friction.z == fixtures::relative(0.03 * normal, 1e-12));
  // a step in which Coulomb's force would turn the sliding round many times
  const double dt = 1, gained = force_of(touch, law, dt).friction.z * dt / touch.reduced_mass;
  CHECK(4 * gained == fixtures::relative(touch.velocity.z, 1e-12));
  touch.velocity = {3, 0, 0};
  CHECK(force_of(touch, law, 1e-9).friction == Vec3d{});
}

TEST_CASE("short-range law: stiffness is 15 times that of the bond-based bond over the horizon, in space and in the plane") {
  const ShortRangeLaw law;
  constexpr double pi = std::numbers::pi;
  const double E = 9e9, horizon = 0.03, thickness = 0.02;
  // c of the literature, written with E: 12 E/(π δ⁴) at ν = 1/4, 9 E/(π h δ³) in plane stress at ν = 1/3 (Madenci and Oterkus 2014)
  CHECK(law.stiffness({E, 0.25, 3}, horizon, 1) == fixtures::relative(15 * 12 * E / (pi * std::pow(horizon, 5)), 1e-12));
  CHECK(law.stiffness({E, 1.0 / 3, 2}, horizon, thickness) == fixtures::relative(15 * 9 * E / (pi * thickness * std::pow(horizon, 4)), 1e-12));
  CHECK(in_series(3.0, 3.0) == fixtures::relative(3.0, 1e-15));
  CHECK(in_series(1.0, 1e9) == fixtures::relative(2.0, 1e-8));  // the softer of the two gives way
}
