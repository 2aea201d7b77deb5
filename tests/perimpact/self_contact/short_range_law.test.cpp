#include "perimpact/self_contact/short_range_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/force/piles.hpp"

using namespace perimpact;

namespace {

/// Coefficient of restitution of a linear oscillator until the force vanishes, converged in the step.
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

/// Two particles collide at 1 m/s each; returns the coefficient of restitution. `steps` per radian of the contact.
double restitution_of_two(double wanted, double steps) {
  const double size = 0.001;
  fixtures::Pile pile{.law = {.damping_ratio = damping_ratio_of(wanted)}, .bodies = {}};
  pile.bodies.push_back(fixtures::lone_particle(size, {-0.55 * size, 0, 0}, {1, 0, 0}));
  pile.bodies.push_back(fixtures::lone_particle(size, {0.55 * size, 0, 0}, {-1, 0, 0}));
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  const double mass = pile.bodies[0].particles.mass(pile.bodies[0].particles.slot_of()[0]), volume = size * size * size;
  const double dt = 1 / steps / std::sqrt(bodies[0].stiffness * volume * volume / (0.5 * mass));
  std::vector<double> travel(1);
  const fixtures::Threads with_one(1);  // two particles are not worth waking another
  bool touched = false;
  double energy = 0;
  for (int step = 0; step < 100000; ++step) {
    for (Body& body : pile.bodies) advance(body.particles, dt, travel);
    pile.clear_forces();
    contact.add_forces(bodies, dt);
    touched = touched || contact.contacts() > 0;
    energy = fixtures::larger(energy, contact.energy());
    if (touched && contact.contacts() == 0) break;
  }
  REQUIRE(touched);
  if (wanted == 1) CHECK(energy == fixtures::relative(mass, 0.01));  // 2 m v²/2 all in the spring, but for where in a step its end falls
  const double relative_velocity = pile.bodies[1].particles.velocity.at(0).x - pile.bodies[0].particles.velocity.at(0).x;
  // the dissipation of the dashpot is the energy lost
  CHECK(mass * (1 - 0.25 * relative_velocity * relative_velocity) == fixtures::absolute(contact.dashpot_dissipation(), 0.01 * mass, "J"));
  return relative_velocity / 2;
}

}  // namespace

TEST_CASE("short-range law: the damping ratio gives the required restitution, from weak to overdamped") {
  CHECK(damping_ratio_of(1) == 0);
  for (const double e : {0.95, 0.8, 0.5, 0.2, std::exp(-2.0), 0.1}) {
    CAPTURE(e);
    CHECK(integrated_restitution(damping_ratio_of(e)) == fixtures::relative(e, 1e-3));  // first order in the step of 1e-5, over a few radians
  }
  CHECK(damping_ratio_of(std::exp(-2.0)) == fixtures::relative(1, 1e-6));  // where the two branches meet
}

TEST_CASE("short-range law: two particles rebound with the restitution of the deck, and the dashpot dissipation is their energy loss") {
  for (const double e : {1.0, 0.9, 0.5, 0.2}) {
    CAPTURE(e);
    CHECK(restitution_of_two(e, 200) == fixtures::relative(e, 0.02));  // velocities are half a step old: 2 ζ/200 of a radian, and the end of contact
  }
}

TEST_CASE("short-range law: friction stores energy up to Coulomb's limit and dissipates slip beyond it, the same for any step") {
  const ShortRangeLaw law{.friction = 0.3};
  const double k = 1e8, normal = 1e3, most = 0.3 * 0.9 * normal;
  for (const int steps : {10, 1000}) {
    CAPTURE(steps);
    Vec3d slip{};
    double work = 0, stored = 0;
    ParticleContactForce force;
    for (const double speed : {5.0, -20.0, 0.02}) {  // to, fro, and hardly any more; 1 ms each
      const ParticleContact pair_contact{.direction = {1, 0, 0},
                                         .velocity = {7, 0, speed},
                                         .spring = normal,
                                         .stiffness = 1e9,
                                         .reduced_mass = 1e-3,
                                         .tangential_stiffness = k,
                                         .oblique_share = 0.9};
      for (int n = 0; n < steps; ++n) {
        force = force_of(pair_contact, law, 1e-3 / steps, slip);
        CHECK(force.friction_dissipation >= 0);
        work += force.friction_dissipation, stored = force.tangential_energy;
      }
      if (std::fabs(speed) > 1) CHECK(std::fabs(force.friction.z) == fixtures::relative(most, 1e-12));  // rounding
    }
    const double elastic = most / k;  // [m] that the spring gives
    // forward: 5 mm less the spring's extension; back: 20 mm less twice that; finally the spring releases 20 µm, 5.4 of them to come to rest
    CHECK(force.friction.z == fixtures::relative(most, 1e-12));
    CHECK(work == fixtures::relative(most * (5e-3 - elastic + 20e-3 - 2 * elastic + 20e-6 - 2 * elastic),
                                     0.92 / steps));  // of the first step half is lost, of that of the turn all
    CHECK(stored == fixtures::relative(0.5 * most * most / k, 1e-12));
  }
  Vec3d slip{};
  ParticleContact still{
      .direction = {1, 0, 0}, .velocity = {3, 0, 0}, .spring = normal, .stiffness = 1e9, .reduced_mass = 1e-3, .tangential_stiffness = k, .oblique_share = 1};
  CHECK(force_of(still, law, 1e-6, slip).friction == Vec3d{});
}

TEST_CASE("short-range law: a tangential spring that rotates with its pair keeps its energy, and what is left at loss of contact is dissipated") {
  const ShortRangeLaw law{.friction = 0.5};
  ParticleContact pair_contact{
      .direction = {1, 0, 0}, .velocity = {}, .spring = 1e6, .stiffness = 1e9, .reduced_mass = 1e-3, .tangential_stiffness = 1e8, .oblique_share = 1};
  Vec3d slip{0, 1e-6, 0};
  const double held = 0.5 * 1e8 * 1e-12;
  for (int n = 0; n <= 100; ++n) {
    pair_contact.direction = {std::cos(0.01 * n), std::sin(0.01 * n), 0};
    CHECK(force_of(pair_contact, law, 1e-6, slip).tangential_energy == fixtures::relative(held, 1e-12));
    CHECK(std::fabs(dot(slip, pair_contact.direction)) <= 1e-18);  // rounding of a micrometre
  }
  pair_contact.spring = 0;
  const ParticleContactForce released = force_of(pair_contact, law, 1e-6, slip);
  CHECK(released.friction_dissipation == fixtures::relative(held, 1e-12));
  CHECK(released.tangential_energy == 0);
}

TEST_CASE("short-range law: constants of a face are those of a sum over a lattice, and the slope is the derivative of the weight") {
  // threshold: the phase of largest density, at the contact distance; slope: the mean over phases, by a difference
  for (const bool plane : {false, true}) {
    const Face face = plane ? face_in_plane : face_in_space;
    const auto density = [&](double z, double u, double v) {
      double sum = 0;
      for (int m = -3; m <= 3; ++m)
        for (int n = plane ? 0 : -3; n <= (plane ? 0 : 3); ++n) sum += contact_weight(z * z + (m - u) * (m - u) + (n - v) * (n - v));
      return sum;
    };
    double most = 0, slope = 0;
    constexpr int phases = 40;
    for (int m = 0; m < phases; ++m)
      for (int n = 0; n < (plane ? 1 : phases); ++n) {
        const double u = double(m) / phases, v = double(n) / phases;
        most = fixtures::larger(most, density(1, u, v));
        slope += (density(0.9999, u, v) - density(1.0001, u, v)) / 2e-4 / (plane ? phases : phases * phases);
      }
    CHECK(face.density == fixtures::relative(most, 1e-5));  // its digits
    CHECK(face.density >= most);
    CHECK(face.slope == fixtures::relative(slope, 1e-4));  // its digits
  }
  for (const double q : {0.1, 0.9, 1.7})
    CHECK(contact_weight_slope(q * q) * q ==
          fixtures::relative((contact_weight((q - 1e-5) * (q - 1e-5)) - contact_weight((q + 1e-5) * (q + 1e-5))) / 2e-5, 1e-7));
  CHECK(contact_weight(4.0) == 0);
  CHECK(contact_weight(9.0) == 0);
}

TEST_CASE("short-range law: stiffness is 15 times that of the bond-based bond over the horizon, in 3-D and 2-D") {
  const ShortRangeLaw law;
  constexpr double pi = std::numbers::pi;
  const double E = 9e9, horizon = 0.03, thickness = 0.02;
  // c of the literature, written with E: 12 E/(π δ⁴) at ν = 1/4, 9 E/(π h δ³) in plane stress at ν = 1/3 (Madenci and Oterkus 2014)
  CHECK(law.stiffness({E, 0.25, 3}, horizon, 1) == fixtures::relative(15 * 12 * E / (pi * std::pow(horizon, 5)), 1e-12));
  CHECK(law.stiffness({E, 1.0 / 3, 2}, horizon, thickness) == fixtures::relative(15 * 9 * E / (pi * thickness * std::pow(horizon, 4)), 1e-12));
  CHECK(in_series(3.0, 3.0) == fixtures::relative(3.0, 1e-15));
  CHECK(in_series(1.0, 1e9) == fixtures::relative(2.0, 1e-8));  // the softer of the two gives way
}
