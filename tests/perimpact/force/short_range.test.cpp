// The short-range force on particles in given places: against a sum over all pairs, and what must be nothing.
#include "perimpact/force/short_range.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "fixtures/tolerance.hpp"
#include "perimpact/force/piles.hpp"

using namespace perimpact;
using fixtures::launch;
using fixtures::Pile;
using fixtures::shatter;

namespace {

struct AllPairs {
  std::vector<std::vector<Vec3d>> force;  // [N] of each body and slot
  double energy = 0;
  std::size_t touching = 0;
};

/// The law as the page has it, over all pairs; bonds and surfaces are found by other ways than the code's.
AllPairs sum_over_all_pairs(const Pile& pile, double dt) {
  struct Particle {
    std::size_t body, slot;
    Vec3d X, x, v;
    double size, volume, mass;
    std::set<std::size_t> bonds;
    bool exposed;
  };
  std::vector<Particle> particles;
  for (std::size_t b = 0; b < pile.bodies.size(); ++b) {
    const Body& body = pile.bodies[b];
    const Particles& p = body.particles;
    for (const std::uint32_t slot : p.slot_of()) {
      Particle one{b, slot, p.reference(slot), p.position.at(slot), p.velocity.at(slot), 0, p.volume(slot), p.mass(slot), {}, true};
      one.size = p.is_plane() ? std::sqrt(one.volume / *p.thickness()) : std::cbrt(one.volume);
      body.family.for_each_bond(slot, [&](const FamilyBond& bond) { one.bonds.insert(bond.j); });
      if (p.lattice()) {
        int nearest = 0;
        for (const std::uint32_t other : p.slot_of()) nearest += std::fabs(norm(p.reference(other) - one.X) / p.spacing() - 1) < 1e-6;
        one.exposed = nearest < (p.is_plane() ? 4 : 6) || body.family.damage(slot) > 0;
      }
      particles.push_back(one);
    }
  }
  AllPairs sum;
  for (const Body& body : pile.bodies) sum.force.emplace_back(body.particles.slots());
  std::vector<double> k;
  for (const Body& body : pile.bodies)
    k.push_back(pile.law.stiffness(body.internal.ordinary_state()->law().elastic(), body.family.horizon(), body.particles.thickness().value_or(1)));
  for (std::size_t a = 0; a < particles.size(); ++a)
    for (std::size_t b = a + 1; b < particles.size(); ++b) {
      const Particle &i = particles[a], &j = particles[b];
      const double mean = (i.size + j.size) / 2, r = norm(j.x - i.x);
      double d = pile.law.distance_ratio * mean;
      if (i.body == j.body) {
        if (i.bonds.contains(j.slot)) continue;
        d = std::min(0.9 * norm(j.X - i.X), pile.law.debris_distance_ratio * mean);
      }
      if (r >= d || !(i.exposed || j.exposed)) continue;
      const double ki = k[i.body], kj = k[j.body], K = 2 / (1 / ki + 1 / kj) * i.volume * j.volume, m = 1 / (1 / i.mass + 1 / j.mass);
      const Vec3d n = (j.x - i.x) / r, w = j.v - i.v, sliding = w - dot(w, n) * n;
      const double normal = std::max(0.0, K * (d - r) - 2 * pile.law.damping_ratio * std::sqrt(K * m) * dot(w, n));
      const double most = pile.law.friction * normal;
      const Vec3d force = most / std::max({norm(sliding), pile.law.friction_speed, 4 * most * dt / m}) * sliding - normal * n;
      sum.force[i.body][i.slot] += force;
      sum.force[j.body][j.slot] += -force;
      sum.energy += K * (d - r) * (d - r) / 2;
      ++sum.touching;
    }
  return sum;
}

/// The largest difference of forces, over the largest force.
double difference(const Pile& pile, const AllPairs& expected) {
  double largest = 0, apart = 0;
  for (std::size_t b = 0; b < pile.bodies.size(); ++b)
    for (const std::uint32_t slot : pile.bodies[b].particles.slot_of()) {
      const Particles& particles = pile.bodies[b].particles;
      largest = std::max(largest, norm(expected.force[b][slot]));
      apart = std::max(apart, norm(particles.volume(slot) * particles.force_density.at(slot) - expected.force[b][slot]));
    }
  return apart / largest;
}

constexpr double spacing = 0.001;

/// A block of which a part is loose, and another with other spacings and another material that has run into it; all shaken.
Pile wreck(fixtures::Points points, PlaneState plane, double share) {
  const Vec3d size = plane == PlaneState::none ? Vec3d{0.008, 0.006, 0.005} : Vec3d{0.016, 0.012, 0.002};
  Pile pile{.law = {.friction = 0.3, .friction_speed = 0.5, .damping_ratio = 0.2}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = size, .spacing = spacing, .plane = plane, .points = points}));
  fixtures::BodyOptions finer{.size = 0.5 * size, .spacing = 0.5 * spacing, .poissons_ratio = 0.3, .plane = plane, .points = points};
  if (plane != PlaneState::none) finer.size.z = size.z;
  pile.bodies.push_back(fixtures::body(finer));
  shatter(pile.bodies[0], share);
  shatter(pile.bodies[1], 0.5 * share);
  launch(pile.bodies[1], {0.7 * size.x, 0.2 * size.y, 0}, {});
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> speed(-30, 30);
  for (Body& body : pile.bodies) {
    fixtures::shake(body, 0.35 * body.particles.spacing(), 13);
    for (const std::uint32_t slot : body.particles.slot_of())
      body.particles.velocity.set(slot, {speed(random), speed(random), body.particles.is_plane() ? 0 : speed(random)});
  }
  return pile;
}

}  // namespace

TEST_CASE("short range: forces are those of a sum over all pairs, for lattices and clouds, in space and in the plane, whole to all in pieces") {
  constexpr double dt = 1e-8;
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::listed, fixtures::Points::shaken})
    for (const auto plane : {PlaneState::none, PlaneState::stress})
      for (const double share : {0.0, 0.05, 1.0}) {
        CAPTURE(static_cast<int>(points));
        CAPTURE(static_cast<int>(plane));
        CAPTURE(share);
        Pile pile = wreck(points, plane, share);
        const auto bodies = pile.touching();
        ShortRange contact(pile.law, bodies);
        contact.add_forces(bodies, dt);
        const AllPairs expected = sum_over_all_pairs(pile, dt);
        REQUIRE(expected.touching > 20);
        CHECK(contact.touching() == expected.touching);
        CHECK(difference(pile, expected) <= 1e-12);  // sums of some ten forces, in another order
        CHECK(contact.energy() == fixtures::relative(expected.energy, 1e-12));
      }
}

TEST_CASE("short range: bonds that break and particles that wander are felt in the same step, list or no list") {
  constexpr double dt = 1e-8;
  Pile pile = wreck(fixtures::Points::lattice, PlaneState::none, 0.02);
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> move(-1, 1);
  for (int round = 0; round < 12; ++round) {
    const double way = (round % 3 == 0 ? 0.4 : 0.03) * spacing;  // beyond the skin, and within it
    for (Body& body : pile.bodies)
      for (const std::uint32_t slot : body.particles.slot_of())
        body.particles.position.set(slot, body.particles.position.at(slot) + way * Vec3d{move(random), move(random), move(random)});
    if (round % 4 == 2) {  // everything about one particle breaks, as the bond pass would have it
      Body& body = pile.bodies[0];
      const std::size_t where = body.particles.slot_of()[static_cast<std::size_t>(round) * 17];
      body.family.cut([&](std::size_t i, std::size_t j) { return i == where || j == where; });
      body.internal.visit_state("", [&](const std::string&, std::span<std::size_t> ends) {
        for (std::size_t& end : ends) ++end;
      });
    }
    pile.clear_forces();
    contact.add_forces(bodies, dt);
    REQUIRE(difference(pile, sum_over_all_pairs(pile, dt)) <= 1e-12);
  }
  CHECK(contact.near_pairs().times_made() < 12);
}

TEST_CASE("short range: the first bonds of a whole block that break are felt in the same step, though nothing moved by the skin") {
  Pile pile{.law = {}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.011, 0.009, 0.009}, .spacing = spacing}));
  Body& body = pile.bodies[0];
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  contact.add_forces(bodies, 1e-8);
  REQUIRE(contact.touching() == 0);
  const Lattice& lattice = *body.particles.lattice();
  const std::size_t where = lattice.slot(5, 4, 4);  // deep inside
  body.family.cut([&](std::size_t i, std::size_t j) { return i == where || j == where; });
  body.internal.visit_state("", [&](const std::string&, std::span<std::size_t> ends) {
    for (std::size_t& end : ends) ++end;  // as the bond pass counts them
  });
  body.particles.position.set(where,
                              body.particles.position.at(where) + Vec3d{0.2 * spacing, 0, 0});  // within the skin; nearer than 0.9 of a spacing to the next
  pile.clear_forces();
  contact.add_forces(bodies, 1e-8);
  CHECK(contact.touching() >= 1);
  CHECK(difference(pile, sum_over_all_pairs(pile, 1e-8)) <= 1e-12);
}

TEST_CASE("short range: linear momentum is kept to rounding, angular momentum only without friction") {
  for (const double friction : {0.0, 0.3}) {
    Pile pile = wreck(fixtures::Points::shaken, PlaneState::none, 0.5);
    pile.law.friction = friction;
    const auto bodies = pile.touching();
    ShortRange contact(pile.law, bodies);
    contact.add_forces(bodies, 1e-8);
    CHECK(norm(pile.force()) <= 1e-14 * pile.magnitude());
    const double arm = 0.008, moment = norm(pile.moment()) / (pile.magnitude() * arm);
    if (friction == 0)
      CHECK(moment <= 1e-14);
    else
      CHECK(moment > 1e-6);  // opposite forces with a lever of up to one contact distance between them
  }
}

TEST_CASE("short range: neighbours with an intact bond feel nothing, stretched or pressed") {
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::shaken})
    for (const double stretch : {1.3, 0.7, 0.4}) {
      CAPTURE(stretch);
      Pile pile{.law = {}, .bodies = {}};
      pile.bodies.push_back(fixtures::body({.size = {0.008, 0.006, 0.005}, .points = points}));
      fixtures::deform(pile.bodies[0], [&](const Vec3d& X) { return Vec3d{stretch * X.x, X.y, X.z}; });
      const auto bodies = pile.touching();
      ShortRange contact(pile.law, bodies);
      contact.add_forces(bodies, 1e-8);
      CHECK(contact.touching() == 0);
      CHECK(pile.magnitude() == 0);
    }
}

TEST_CASE("short range: a thin plate folded upon itself touches itself, without a broken bond") {
  Pile pile{.law = {}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.04, 0.004, 0.002}, .spacing = spacing}));
  const double radius = 0.0022;  // of the fold: the two halves lie 4.4 mm apart but for the thickness, and are pressed further
  fixtures::deform(pile.bodies[0], [&](const Vec3d& X) {
    const double angle = X.x / radius, half = 0.5 * std::numbers::pi;
    if (std::fabs(angle) < half) return Vec3d{(radius + X.z) * std::cos(angle), X.y, (radius + X.z) * std::sin(angle)};
    const double side = X.x > 0 ? 1 : -1, along = std::fabs(X.x) - radius * half;
    return Vec3d{-along, X.y, side * (radius + X.z - 0.1 * along)};
  });
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  contact.add_forces(bodies, 1e-8);
  CHECK(contact.touching() > 10);
  CHECK(difference(pile, sum_over_all_pairs(pile, 1e-8)) <= 1e-12);
}

TEST_CASE("short range: bodies that fly together need no new list, however far") {
  Pile pile = wreck(fixtures::Points::lattice, PlaneState::none, 0.3);
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  for (int step = 0; step < 20; ++step) {
    contact.add_forces(bodies, 1e-8);
    for (Body& body : pile.bodies) launch(body, {0.01, -0.02, 0.03}, {});
  }
  CHECK(contact.near_pairs().times_made() == 1);
}

TEST_CASE("short range: particles in one place are pushed nowhere, and nothing becomes infinite") {
  Pile pile{.law = {.friction = 0.3}, .bodies = {}};
  pile.bodies.push_back(fixtures::lone_particle(spacing, {}, {1, 0, 0}));
  pile.bodies.push_back(fixtures::lone_particle(spacing, {}, {-1, 0, 0}));
  const auto bodies = pile.touching();
  ShortRange contact(pile.law, bodies);
  contact.add_forces(bodies, 1e-8);
  CHECK(pile.magnitude() == 0);
}
