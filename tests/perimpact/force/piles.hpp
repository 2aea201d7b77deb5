/// Bodies in contact, for tests of the short-range force: their set-up, the cutting of bonds, and one step.
#pragma once

#include <limits>
#include <random>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/particles/advance.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace fixtures {

using namespace perimpact;

/// Several bodies and their contact law; the force depends on their states only.
struct Pile {
  ShortRangeLaw law;
  std::vector<Body> bodies;
  double largest_pressure = std::numeric_limits<double>::infinity();  // [Pa] of each body

  std::vector<ContactingBody> contacts() {
    std::vector<ContactingBody> all;
    for (Body& body : bodies) {
      const IsotropicElastic& elastic = body.internal.ordinary_state()->law().elastic();
      all.push_back({body.particles, body.family, body.internal.broken_ends(),
                     law.stiffness(elastic, body.family.horizon(), body.particles.thickness().value_or(1)), largest_pressure});
    }
    return all;
  }

  void clear_forces() {
    for (Body& body : bodies)
      for (const std::uint32_t slot : body.particles.slot_of()) body.particles.force_density.set(slot, {});
  }

  /// Σ V f [N]
  Vec3d force() const {
    Vec3d sum{};
    for (const Body& body : bodies)
      for (const std::uint32_t slot : body.particles.slot_of()) sum += body.particles.volume(slot) * body.particles.force_density.at(slot);
    return sum;
  }
  /// Σ x × V f [N m]
  Vec3d moment() const {
    Vec3d sum{};
    for (const Body& body : bodies)
      for (const std::uint32_t slot : body.particles.slot_of())
        sum += cross(body.particles.position.at(slot), body.particles.volume(slot) * body.particles.force_density.at(slot));
    return sum;
  }
  /// Σ |V f| [N]: scale of rounding.
  double magnitude() const {
    double sum = 0;
    for (const Body& body : bodies)
      for (const std::uint32_t slot : body.particles.slot_of()) sum += norm(body.particles.volume(slot) * body.particles.force_density.at(slot));
    return sum;
  }
};

/// Displaces all particles of a body and sets their velocity.
inline void launch(Body& body, const Vec3d& by, const Vec3d& velocity) {
  for (const std::uint32_t slot : body.particles.slot_of()) {
    body.particles.position.set(slot, body.particles.position.at(slot) + by);
    body.particles.velocity.set(slot, velocity);
  }
}

/// Cuts all bonds of the given fraction of the particles.
inline void shatter(Body& body, double share, unsigned seed = 3) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> loose(body.particles.slots());
  for (const std::uint32_t slot : body.particles.slot_of()) loose[slot] = std::uniform_real_distribution<double>(0, 1)(random) < share;
  body.family.cut([&](std::size_t i, std::size_t j) { return loose[i] || loose[j]; });
}

/// A body of one particle, an edge of `size` [m] wide.
inline Body lone_particle(double size, const Vec3d& place, const Vec3d& velocity) {
  const BodySetup setup = body_setup({.spacing = size});
  Body body = make_body(setup, Particles(Cloud{.points = {place}, .volumes = {size * size * size}}, density));
  launch(body, {}, velocity);
  return body;
}

}  // namespace fixtures
