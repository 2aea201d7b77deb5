// The short-range force on particles at given positions: against a sum over all pairs, and cases without force.
#include "perimpact/self_contact/short_range.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>
#include <type_traits>

#include "fixtures/tolerance.hpp"
#include "perimpact/force/piles.hpp"
#include "perimpact/self_contact/all_pairs.hpp"

using namespace perimpact;
using fixtures::AllPairs;
using fixtures::difference;
using fixtures::launch;
using fixtures::Pile;
using fixtures::shatter;

namespace {

constexpr double spacing = 0.001;

/// A partly fragmented block, and another of different spacing and material that penetrates it; all with random velocities.
Pile wreck(fixtures::Points points, Plane plane, double share, double damping_ratio) {
  const Vec3d size = plane == Plane::none ? Vec3d{0.008, 0.006, 0.005} : Vec3d{0.016, 0.012, 0.002};
  Pile pile{.law = {.friction = 0.3, .damping_ratio = damping_ratio}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = size, .spacing = spacing, .plane = plane, .points = points}));
  fixtures::BodyOptions finer{.size = 0.5 * size, .spacing = 0.5 * spacing, .poissons_ratio = 0.3, .plane = plane, .points = points};
  if (plane != Plane::none) finer.size.z = size.z;
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

/// Breaks the bonds between slots i and j for which breaks(i, j). Every eight counts a broken end, as if it had lost a bond as well.
template <class Breaks>
void break_bonds(Body& body, const Breaks& breaks) {
  body.family.cut(breaks);
  body.internal.visit_state("", [](const std::string&, auto values) {
    if constexpr (std::is_base_of_v<std::span<std::uint32_t>, decltype(values)>)
      for (std::uint32_t& end : values) ++end;
  });
}

/// Moves all particles with their velocities.
void drift(Pile& pile, double dt) {
  for (Body& body : pile.bodies)
    for (const std::uint32_t slot : body.particles.slot_of())
      body.particles.position.set(slot, body.particles.position.at(slot) + dt * body.particles.velocity.at(slot));
}

}  // namespace

TEST_CASE(
    "short range: forces are those of a sum over all pairs, for lattices and clouds, in 3-D and 2-D, intact to fully fragmented, with and without "
    "dashpots, by packs and one pair at a time") {
  constexpr double dt = 1e-6;  // particles go 0.03 of a spacing a step
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::listed, fixtures::Points::shaken})
    for (const auto plane : {Plane::none, Plane::stress})
      for (const auto& one :
           {std::tuple{0.0, 0.2, false}, {0.05, 0.2, false}, {1.0, 0.2, false}, {1.0, 0.2, true}, {0.05, 0.0, false}, {0.05, 0.0, true}, {1.0, 0.0, false}}) {
        const double share = std::get<0>(one), damping_ratio = std::get<1>(one);
        const bool is_scalar = std::get<2>(one);
        CAPTURE(static_cast<int>(points));
        CAPTURE(static_cast<int>(plane));
        CAPTURE(share);
        CAPTURE(damping_ratio);
        CAPTURE(is_scalar);
        Pile pile = wreck(points, plane, share, damping_ratio);
        const auto bodies = pile.contacts();
        ShortRange contact(pile.law, bodies);
        if (is_scalar) contact.use_scalar_kernel();
        AllPairs expected;
        for (int step = 0; step < 6; ++step) {
          pile.clear_forces();
          contact.add_forces(bodies, step > 0 ? dt : 0);
          expected.evaluate(pile, step > 0 ? dt : 0);
          REQUIRE(expected.contacts > 20);
          CHECK(contact.contacts() == expected.contacts);
          CHECK(difference(pile, expected) <= 1e-10);  // sums of some twenty forces in another order, of overlaps that are small differences
          CHECK(contact.energy() == fixtures::relative(expected.energy, 1e-10));
          if (step > 0) {
            CHECK(contact.friction_dissipation() == fixtures::relative(expected.friction_dissipation, 1e-9));
            if (damping_ratio > 0) CHECK(contact.dashpot_dissipation() == fixtures::relative(expected.damped_work, 1e-9));
            if (damping_ratio == 0) CHECK(contact.dashpot_dissipation() == 0);
          }
          drift(pile, dt);
        }
      }
}

TEST_CASE("short range: bond failure, motion and compaction take effect in the same step, with and without the list, by packs and one pair at a time") {
  constexpr double dt = 1e-8;
  for (const bool is_scalar : {false, true}) {
    CAPTURE(is_scalar);
    Pile pile = wreck(fixtures::Points::lattice, Plane::none, 0.02, 0.2);
    pile.largest_pressure = 2e6;  // some particles yield, and some do not
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    if (is_scalar) contact.use_scalar_kernel();
    AllPairs expected;
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> move(-1, 1);
    for (int round = 0; round < 12; ++round) {
      const double way = (round % 3 == 0 ? 0.4 : 0.03) * spacing;  // beyond the skin, and within it
      for (Body& body : pile.bodies)
        for (const std::uint32_t slot : body.particles.slot_of())
          body.particles.position.set(slot, body.particles.position.at(slot) + way * Vec3d{move(random), move(random), move(random)});
      if (round % 4 == 2) {  // all bonds of one particle break
        Body& body = pile.bodies[0];
        const std::size_t where = body.particles.slot_of()[static_cast<std::size_t>(round) * 17];
        break_bonds(body, [&](std::size_t i, std::size_t j) { return i == where || j == where; });
      }
      pile.clear_forces();
      contact.add_forces(bodies, dt);
      expected.evaluate(pile, dt);
      REQUIRE(difference(pile, expected) <= 1e-10);
      if (expected.compaction > 0) CHECK(contact.compaction_dissipation() == fixtures::relative(expected.compaction, 1e-9));
    }
    CHECK(contact.compaction_dissipation() > 0);
    CHECK(contact.near_pairs().times_made() < 12);
  }
}

TEST_CASE("short range: bonds that break need no new list, whether or not it has room for their pairs, and tangential springs are not lost") {
  constexpr double dt = 1e-6;
  Pile pile{.law = {.friction = 0.3}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.011, 0.009, 0.009}, .spacing = spacing}));
  Body& body = pile.bodies[0];
  fixtures::deform(body, [&](const Vec3d& X) { return Vec3d{0.8 * X.x, X.y, X.z}; });
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> speed(-20, 20);  // 0.02 of a spacing a step
  for (const std::uint32_t slot : body.particles.slot_of()) body.particles.velocity.set(slot, {speed(random), speed(random), speed(random)});
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  AllPairs expected;
  const Lattice& lattice = *body.particles.lattice();
  const std::size_t where = lattice.slot(5, 4, 4);
  const auto cut = [&](const auto& loses_bond_to) {
    break_bonds(body, [&](std::size_t i, std::size_t j) { return (i == where && loses_bond_to(j)) || (j == where && loses_bond_to(i)); });
  };
  const auto new_lists = [&] {
    const std::size_t before = contact.near_pairs().times_made();
    pile.clear_forces();
    contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
    CHECK(difference(pile, expected) <= 1e-10);
    if (expected.friction_dissipation > 0) CHECK(contact.friction_dissipation() == fixtures::relative(expected.friction_dissipation, 1e-9));
    drift(pile, dt);
    return contact.near_pairs().times_made() - before;
  };
  cut([&](std::size_t other) { return other == lattice.slot(6, 4, 4); });
  CHECK(new_lists() == 1);  // the first
  cut([&](std::size_t other) { return other == lattice.slot(4, 4, 4) || other == lattice.slot(5, 3, 4) || other == lattice.slot(5, 4, 5); });
  CHECK(new_lists() == 0);
  CHECK(new_lists() == 0);
  CHECK(contact.contacts() > 0);
  CHECK(expected.friction_dissipation > 0);
  const auto is_near = [&](std::size_t other) { return norm(lattice.centre(other) - lattice.centre(where)) < 2.3 * spacing; };
  cut(is_near);  // 56 bonds, to particles next to those that had lost one before
  CHECK(new_lists() == 0);
  CHECK(new_lists() == 0);
}

TEST_CASE("short range: bond failure in place causes no repulsion, and contact acts from that distance on, from the step of failure") {
  for (const double squeeze : {1.0, 0.7}) {
    CAPTURE(squeeze);
    Pile pile{.law = {}, .bodies = {}};
    pile.bodies.push_back(fixtures::body({.size = {0.011, 0.009, 0.009}, .spacing = spacing}));
    Body& body = pile.bodies[0];
    fixtures::deform(body, [&](const Vec3d& X) { return Vec3d{squeeze * X.x, X.y, X.z}; });
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    AllPairs expected;
    contact.add_forces(bodies, 0), expected.evaluate(pile, 0);
    REQUIRE(contact.contacts() == 0);
    const Lattice& lattice = *body.particles.lattice();
    const std::size_t where = lattice.slot(5, 4, 4);  // deep inside, where nothing is listed yet
    break_bonds(body, [&](std::size_t i, std::size_t j) { return i == where || j == where; });
    const auto evaluate = [&] {
      pile.clear_forces();
      contact.add_forces(bodies, 1e-8), expected.evaluate(pile, 1e-8);
      CHECK(difference(pile, expected) <= 1e-10);
    };
    contact.add_forces(bodies, 1e-8), expected.evaluate(pile, 1e-8);
    CHECK(contact.contacts() == 0);
    CHECK(contact.energy() == 0);
    const auto shift = [&](double by) { body.particles.position.set(where, body.particles.position.at(where) + Vec3d{by * spacing, 0, 0}); };
    // closer to one and farther from the other: the densities of both ends increase
    shift(0.2);
    evaluate();
    CHECK(contact.contacts() >= 1);
    CHECK(contact.energy() > 0);
  }
}

TEST_CASE("short range: a crack in any direction closes where it opened, without force, unless it has opened by more than a tenth of the contact distance") {
  for (const Vec3d& normal : {Vec3d{1, 0, 0}, Vec3d{1, 1, 0}, Vec3d{2, 1, 0}, Vec3d{1, 1, 1}}) {
    CAPTURE(normal.y);
    CAPTURE(normal.z);
    const Vec3d n = normal / norm(normal);
    Pile pile{.law = {}, .bodies = {}};
    pile.bodies.push_back(fixtures::body({.size = {0.011, 0.011, 0.011}, .spacing = spacing}));
    Body& body = pile.bodies[0];
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    AllPairs expected;
    const auto is_beyond = [&](std::size_t slot) { return dot(n, body.particles.reference(slot)) > 0.2 * spacing; };
    break_bonds(body, [&](std::size_t i, std::size_t j) { return is_beyond(i) != is_beyond(j); });
    double before = 0;
    const auto energy_at = [&](double opening) {  // [spacings]
      constexpr double dt = 1e-8;
      for (const std::uint32_t slot : body.particles.slot_of())
        if (is_beyond(slot)) body.particles.velocity.set(slot, (opening - before) * spacing / dt * n);
      before = opening;
      fixtures::deform(body, [&](const Vec3d& X) { return dot(n, X) > 0.2 * spacing ? X + opening * spacing * n : X; });
      pile.clear_forces();
      contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
      CHECK(difference(pile, expected) <= 1e-10);
      return contact.energy();
    };
    for (const double opening : {0.0, 0.02, 0.05, 0.03, 0.01, 0.0}) CHECK(energy_at(opening) == 0);
    CHECK(energy_at(-0.005) > 0);  // faces that are pressed together
    for (const double opening : {0.0, 0.2, 0.5, 1.0, 1.5, 2.0}) CHECK(energy_at(opening) == 0);
    if (normal.y == 0) continue;  // the density of a face from the start
    CHECK(energy_at(0.01) > 0);   // at the distance of faces, which is more than that of the lattice
  }
}

TEST_CASE("short range: a particle whose bond broke in compression causes repulsion at that distance once it has been out of range") {
  Pile pile{.law = {}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.011, 0.009, 0.009}, .spacing = spacing}));
  Body& body = pile.bodies[0];
  fixtures::deform(body, [&](const Vec3d& X) { return Vec3d{0.7 * X.x, X.y, X.z}; });
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  AllPairs expected;
  constexpr double dt = 1e-6, far = 0.1;
  const auto evaluate = [&] {
    pile.clear_forces();
    contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
    CHECK(difference(pile, expected) <= 1e-10);
  };
  const Lattice& lattice = *body.particles.lattice();
  const std::size_t one = lattice.slot(5, 4, 4), other = lattice.slot(6, 4, 4);
  break_bonds(body, [&](std::size_t i, std::size_t j) { return (i == one && j == other) || (i == other && j == one); });
  evaluate();
  REQUIRE(contact.energy() == 0);
  // `one` remains in the list, for the sake of its bonds, but has no pair without a bond
  const Vec3d place = body.particles.position.at(other);
  body.particles.position.set(other, place + Vec3d{0, 0, far});
  evaluate();
  REQUIRE(contact.near_pairs().times_made() == 2);
  body.particles.position.set(other, place), body.particles.velocity.set(other, {0, 0, -far / dt});
  evaluate();
  CHECK(contact.contacts() == 1);
  CHECK(contact.energy() > 0);
}

TEST_CASE("short range: after forget() broken bonds are found by the bonds themselves, whatever was counted") {
  constexpr double dt = 1e-8;
  Pile pile{.law = {}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.011, 0.009, 0.009}, .spacing = spacing}));
  Body& body = pile.bodies[0];
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  AllPairs expected;
  const auto evaluate = [&] {
    pile.clear_forces();
    contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
    CHECK(difference(pile, expected) <= 1e-10);
  };
  evaluate();
  const std::size_t where = body.particles.lattice()->slot(5, 4, 4);
  body.family.cut([&](std::size_t i, std::size_t j) { return i == where || j == where; });  // counts nothing, as where a window has moved
  contact.forget();
  evaluate();
  body.particles.position.set(where, body.particles.position.at(where) + Vec3d{0.2 * spacing, 0, 0});
  evaluate();
  CHECK(contact.contacts() >= 1);
}

TEST_CASE("short range: linear momentum is conserved to rounding, angular momentum only without friction") {
  for (const double friction : {0.0, 0.3}) {
    Pile pile = wreck(fixtures::Points::shaken, Plane::none, 0.5, 0.2);
    pile.law.friction = friction;
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    for (int step = 0; step < 6; ++step) {
      pile.clear_forces();
      contact.add_forces(bodies, step > 0 ? 1e-6 : 0);
      if (step < 5) drift(pile, 1e-6);
    }
    CHECK(norm(pile.force()) <= 1e-14 * pile.magnitude());
    const double arm = 0.008, moment = norm(pile.moment()) / (pile.magnitude() * arm);
    if (friction == 0)
      CHECK(moment <= 1e-14);
    else
      CHECK(moment > 1e-6);  // opposite forces with a lever of up to one contact distance between them
  }
}

TEST_CASE("short range: no force acts between neighbours with an intact bond, stretched or compressed") {
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::shaken})
    for (const double stretch : {1.3, 0.7, 0.4}) {
      CAPTURE(stretch);
      Pile pile{.law = {}, .bodies = {}};
      pile.bodies.push_back(fixtures::body({.size = {0.008, 0.006, 0.005}, .points = points}));
      fixtures::deform(pile.bodies[0], [&](const Vec3d& X) { return Vec3d{stretch * X.x, X.y, X.z}; });
      const auto bodies = pile.contacts();
      ShortRange contact(pile.law, bodies);
      contact.add_forces(bodies, 1e-8);
      CHECK(contact.contacts() == 0);
      CHECK(pile.magnitude() == 0);
    }
}

TEST_CASE("short range: a thin plate folded onto itself is in self-contact, without a broken bond") {
  Pile pile{.law = {}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.04, 0.004, 0.002}, .spacing = spacing}));
  const double radius = 0.0022;  // of the fold: the two halves lie 4.4 mm apart but for the thickness, and are pressed further
  fixtures::deform(pile.bodies[0], [&](const Vec3d& X) {
    const double angle = X.x / radius, half = 0.5 * std::numbers::pi;
    if (std::fabs(angle) < half) return Vec3d{(radius + X.z) * std::cos(angle), X.y, (radius + X.z) * std::sin(angle)};
    const double side = X.x > 0 ? 1 : -1, along = std::fabs(X.x) - radius * half;
    return Vec3d{-along, X.y, side * (radius + X.z - 0.1 * along)};
  });
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  contact.add_forces(bodies, 1e-8);
  // initially there is no force; further compression makes the halves repel
  AllPairs expected;
  expected.evaluate(pile, 1e-8);
  CHECK(difference(pile, expected) <= 1e-10);
  Body& body = pile.bodies[0];
  for (const std::uint32_t slot : body.particles.slot_of()) {
    const Vec3d x = body.particles.position.at(slot);
    if (x.x < 0) body.particles.position.set(slot, x - Vec3d{0, 0, (x.z > 0 ? 0.3 : -0.3) * spacing});
  }
  pile.clear_forces();
  contact.add_forces(bodies, 1e-8), expected.evaluate(pile, 1e-8);
  CHECK(contact.contacts() > 10);
  CHECK(difference(pile, expected) <= 1e-10);
}

TEST_CASE(
    "short range: a lattice whose bonds are just longer than the reach has no pairs until it breaks or folds, and forces are those of a sum over all pairs") {
  constexpr double dt = 1e-8;
  for (const auto& [plane, family] : {std::pair{Plane::none, FamilyRule::hu_ha_bobaru}, std::pair{Plane::stress, FamilyRule::hu_ha_bobaru},
                                      std::pair{Plane::none, FamilyRule::madenci_oterkus}}) {
    CAPTURE(static_cast<int>(plane));
    CAPTURE(static_cast<int>(family));
    Pile pile{.law = {.friction = 0.3}, .bodies = {}};
    // Pairs at √5 and √6 spacings are within the support of 2 and the skin of a half. By the first rule they have bonds.
    pile.bodies.push_back(fixtures::body({.size = {0.024, 0.007, 0.003}, .spacing = spacing, .horizon_ratio = 2.015, .family = family, .plane = plane}));
    // a coarser body, out of reach of it, whose own pairs are in reach of more
    if (plane == Plane::none) pile.bodies.push_back(fixtures::lone_particle(1.2 * spacing, {1, 0, 0}, {}));
    Body& body = pile.bodies[0];
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    AllPairs expected;
    const auto evaluate = [&] {
      pile.clear_forces();
      contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
      CHECK(contact.contacts() == expected.contacts);
      CHECK(difference(pile, expected) <= 1e-10);
    };
    evaluate();
    if (family == FamilyRule::hu_ha_bobaru) CHECK(contact.near_pairs().pair_count() == 0);
    // in one step, with the velocity that it takes: particles that come into range from outside are pushed back
    const auto move_to = [&](const auto& place_of) {
      for (const std::uint32_t slot : body.particles.slot_of()) {
        const Vec3d to = place_of(body.particles.reference(slot));
        body.particles.velocity.set(slot, (to - body.particles.position.at(slot)) / dt);
        body.particles.position.set(slot, to);
      }
      evaluate();
    };
    if (plane == Plane::none) {
      // folded: halves that have lost no bond, at 3.7 spacings and then at 0.7
      for (const double gap : {3.7 * spacing, 0.7 * spacing}) move_to([&](const Vec3d& X) { return X.x > 0 ? Vec3d{-X.x, X.y, 2 * spacing + gap + X.z} : X; });
      CHECK(expected.contacts > 100);
    }
    // compressed, so that distances of √5 spacings are within reach, without and with a crack
    move_to([](const Vec3d& X) { return X; });
    for (const double stretch : {0.85, 1.0}) move_to([&](const Vec3d& X) { return Vec3d{stretch * X.x, X.y, X.z}; });
    break_bonds(body, [&](std::size_t i, std::size_t j) { return body.particles.reference(i).x * body.particles.reference(j).x < 0; });
    evaluate();
    move_to([](const Vec3d& X) { return Vec3d{0.7 * X.x, X.y, X.z}; });
    CHECK(expected.contacts > 10);
  }
}

TEST_CASE("short range: bodies in common translation need no new list, however far") {
  Pile pile = wreck(fixtures::Points::lattice, Plane::none, 0.3, 0.2);
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  for (int step = 0; step < 20; ++step) {
    contact.add_forces(bodies, 1e-8);
    for (Body& body : pile.bodies) launch(body, {0.01, -0.02, 0.03}, {});
  }
  CHECK(contact.near_pairs().times_made() == 1);
}

TEST_CASE(
    "short range: fast particles come into contact and fly on without a new list, as far as their thicker skin, and forces are those of a sum over all pairs") {
  constexpr double dt = 1e-8, speed = 0.05 * spacing / dt;
  Pile pile{.law = {.friction = 0.3}, .bodies = {}};
  pile.bodies.push_back(fixtures::body({.size = {0.011, 0.011, 0.011}, .spacing = spacing}));  // one particle in a hundred may be fast
  fixtures::deform(pile.bodies[0], [](const Vec3d& X) { return 0.6 * X; });                    // so dense that contact begins farther away
  const double face = 0.6 * 0.005;
  // pairs are in contact within two spacings; lists reach half a spacing farther, and another 1.25 for fast particles
  for (const double y : {-2., 0., 2.})
    pile.bodies.push_back(fixtures::lone_particle(spacing, {face + 2.6 * spacing, y * spacing, 0.3 * spacing}, {-speed, 0, 0}));
  // two that meet each other, and one that flies away
  for (const double side : {-1., 1.}) pile.bodies.push_back(fixtures::lone_particle(spacing, {0, 0.03 + side * 1.885 * spacing, 0}, {0, -side * speed, 0}));
  pile.bodies.push_back(fixtures::lone_particle(spacing, {0, -0.03, 0}, {0, 0, speed}));
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  AllPairs expected;
  for (int step = 0; step < 60; ++step) {
    CAPTURE(step);
    pile.clear_forces();
    contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
    CHECK(contact.contacts() == expected.contacts);
    CHECK(difference(pile, expected) <= 1e-10);
    const auto lists = contact.near_pairs().times_made();
    if (step == 0) CHECK(expected.contacts == 0);
    if (step < 30) CHECK(lists == 1);
    if (step == 29)  // all but the last are in contact
      for (std::size_t b = 1; b <= 5; ++b) CHECK(norm(expected.force[b][pile.bodies[b].particles.slot_of()[0]]) > 0);
    if (step > 30) CHECK(lists == 2);
    drift(pile, dt);
  }
}

TEST_CASE("short range: a pair with a fast particle, exactly as far apart as lists reach with the common skin, is found") {
  constexpr double dt = 1e-8, speed = 0.1 * spacing / dt;
  const Vec3d apart{1.5 * spacing, 2 * spacing, 0};  // 2.5 spacings: two of contact and half of a skin
  const auto size = fixtures::body({.size = {0.011, 0.011, 0.001}, .spacing = spacing}).particles.size();
  std::size_t others = 0, in_contact = 0;
  for (std::size_t which = 0; which < size; ++which) {
    CAPTURE(which);
    Pile pile{.law = {}, .bodies = {}};
    pile.bodies.push_back(fixtures::body({.size = {0.011, 0.011, 0.001}, .spacing = spacing}));
    const Vec3d target = pile.bodies[0].particles.position.at(pile.bodies[0].particles.slot_of()[which]);
    pile.bodies.push_back(fixtures::lone_particle(spacing, target + apart, -speed / (2.5 * spacing) * apart + Vec3d{0, 0, 0.03 * speed}));
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    AllPairs expected;
    for (int step = 0; step < 12; ++step) {
      contact.add_forces(bodies, dt), expected.evaluate(pile, dt);
      others += contact.contacts() != expected.contacts;
      in_contact += expected.contacts;
      drift(pile, dt);
    }
    CHECK(contact.near_pairs().times_made() == 1);
  }
  CHECK(others == 0);
  CHECK(in_contact > 1000);
}

TEST_CASE("short range: coincident particles are not repelled, and all values stay finite") {
  Pile pile{.law = {.friction = 0.3}, .bodies = {}};
  pile.bodies.push_back(fixtures::lone_particle(spacing, {}, {1, 0, 0}));
  pile.bodies.push_back(fixtures::lone_particle(spacing, {}, {-1, 0, 0}));
  const auto bodies = pile.contacts();
  ShortRange contact(pile.law, bodies);
  contact.add_forces(bodies, 1e-8);
  CHECK(contact.near_pairs().pairs_of(0).count == 1);
  CHECK(pile.magnitude() == 0);
  CHECK(std::isfinite(contact.energy()));
}
