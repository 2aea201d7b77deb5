#include "perimpact/force/short_range.hpp"

#include <algorithm>

#include "fccda/core/parallel.hpp"

namespace perimpact {

ShortRange::ShortRange(const ShortRangeLaw& law, std::span<const TouchingBody> bodies) : law_(law), near_pairs_(law, bodies) {}

void ShortRange::add_forces(std::span<const TouchingBody> bodies, double dt) {
  near_pairs_.update(bodies);
  const auto members = near_pairs_.members();
  position_.resize(members.size()), velocity_.resize(members.size()), got_.resize(members.size());
  const auto for_each_member = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(members.size()), [&](std::ptrdiff_t m) { f(static_cast<std::size_t>(m)); });
  };
  for_each_member([&](std::size_t m) {
    const Particles& particles = bodies[members[m].body].particles;
    position_[m] = particles.position.at(members[m].slot);
    velocity_[m] = particles.velocity.at(members[m].slot);
  });
  for_each_member([&](std::size_t m) { got_[m] = add_to(m, bodies, dt); });

  // one after the other: sums of parts would depend on who is in the list
  Got all;
  std::size_t touching = 0;
  for (const Got& got : got_) {
    all.energy += got.energy, all.friction += got.friction, all.restitution += got.restitution;
    touching += got.touching;
  }
  energy_ = all.energy;
  touching_ = touching / 2;
  work_[0] -= all.friction * dt, work_[1] -= all.restitution * dt;
}

ShortRange::Got ShortRange::add_to(std::size_t m, std::span<const TouchingBody> bodies, double dt) const {
  const NearPairs::Member& i = near_pairs_.members()[m];
  const TouchingBody& body = bodies[i.body];
  const std::uint8_t* bonds = body.family.bytes(i.slot / fccda::byte_lanes);
  Got got;
  Vec3d spring{}, dashpot{}, friction{};
  for (const NearPairs::Pair& pair : near_pairs_.pairs_of(m)) {
    const NearPairs::Member& j = near_pairs_.members()[pair.other];
    const Vec3d between = position_[pair.other] - position_[m];
    const double squared = squared_norm(between);
    const bool one_body = i.body == j.body;
    double distance = contact_distance(law_, i.size, j.size);
    if (one_body) {
      const double most = law_.debris_distance_ratio * (0.5 * (i.size + j.size));
      if (!(squared < most * most)) continue;
      if (pair.bond != NearPairs::no_bond && ((bonds[pair.bond] >> (i.slot % fccda::byte_lanes)) & 1u)) continue;
      distance = contact_distance(law_, i.size, j.size, norm(j.reference - i.reference));
    }
    if (!(squared < distance * distance) || squared == 0) continue;  // two in one place are pushed nowhere
    if (!near_pairs_.is_exposed(i) && !near_pairs_.is_exposed(j)) continue;
    const double length = std::sqrt(squared), k = one_body ? body.stiffness : in_series(body.stiffness, bodies[j.body].stiffness);
    const TouchForce force = force_of({.overlap = distance - length,
                                       .direction = between / length,
                                       .velocity = velocity_[pair.other] - velocity_[m],
                                       .stiffness = k * (i.volume * j.volume),
                                       .reduced_mass = i.mass * j.mass / (i.mass + j.mass)},
                                      law_, dt);
    spring += force.spring, dashpot += force.dashpot, friction += force.friction;
    got.energy += 0.5 * force.energy;
    ++got.touching;
  }
  if (got.touching == 0) return got;
  const Vec3d density = body.particles.force_density.at(i.slot) + (spring + dashpot + friction) / i.volume;
  body.particles.force_density.set(i.slot, density);
  const Vec3d middle = velocity_[m] + (0.5 * dt / body.particles.density()) * density;  // of the step's kick: what its work counts with
  got.friction = dot(friction, middle);
  got.restitution = dot(dashpot, middle);
  return got;
}

ShortRange::Bound ShortRange::bound(std::span<const TouchingBody> bodies, std::size_t b) const {
  struct Largest {
    double volume = 0, mass = 0;
  };
  const auto largest = [](const Particles& particles) {
    Largest found;
    for (const std::uint32_t slot : particles.slot_of()) found = {std::max(found.volume, particles.volume(slot)), std::max(found.mass, particles.mass(slot))};
    return found;
  };
  const Largest own = largest(bodies[b].particles);
  Bound bound{};
  for (std::size_t other = 0; other < bodies.size(); ++other) {
    const Largest its = largest(bodies[other].particles);
    const double k = in_series(bodies[b].stiffness, bodies[other].stiffness);
    const double mass = own.mass * its.mass / (own.mass + its.mass);
    bound.stiffness = std::max(bound.stiffness, most_touching * k * its.volume);
    bound.damping = std::max(bound.damping, most_touching * 2 * law_.damping_ratio * std::sqrt(k * its.volume * mass / own.volume));
  }
  return bound;
}

}  // namespace perimpact
