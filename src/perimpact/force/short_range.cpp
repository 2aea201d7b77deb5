#include "perimpact/force/short_range.hpp"

#include <algorithm>

#include "fccda/core/parallel.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Calls visit(other, distance, bond) for those of the pairs that are nearer than their distance, but for rounding, in order.
template <class Visit>
void for_each_near(const NearPairs::Pairs& pairs, const VectorArray& position, const Vec3d& place, const Visit& visit) {
  using Pack = NativePack;
  const std::array<const double*, 3> x = position.pointers();
  const Vec3<Pack> at{Pack(place.x), Pack(place.y), Pack(place.z)};
  for (std::size_t first = 0; first < pairs.count; first += lanes<Pack>) {
    const std::int32_t* others = pairs.others + first;
    const Vec3<Pack> between{gather<Pack>(x[0], others) - at.x, gather<Pack>(x[1], others) - at.y, gather<Pack>(x[2], others) - at.z};
    const Pack squared = fused(between.z, between.z, fused(between.y, between.y, between.x * between.x));
    const Pack distance = load<Pack>(pairs.distances + first);
    constexpr double rounding = 1 + 1e-12;
    unsigned near = bits_where_greater(Pack(rounding) * distance * distance, squared);
    if (pairs.count - first < lanes<Pack>) near &= (1u << (pairs.count - first)) - 1u;
    for (; near != 0; near &= near - 1) {
      const std::size_t lane = static_cast<std::size_t>(__builtin_ctz(near));
      visit(static_cast<std::size_t>(others[lane]), pairs.distances[first + lane], pairs.bonds[first + lane]);
    }
  }
}

}  // namespace

ShortRange::ShortRange(const ShortRangeLaw& law, std::span<const TouchingBody> bodies) : law_(law), near_pairs_(law, bodies) {}

void ShortRange::add_forces(std::span<const TouchingBody> bodies, double dt) {
  near_pairs_.update(bodies);
  const auto members = near_pairs_.members();
  if (position_.slots() != members.size()) position_ = velocity_ = VectorArray(members.size(), 0);
  got_.resize(members.size());
  const auto for_each_member = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(members.size()), [&](std::ptrdiff_t m) { f(static_cast<std::size_t>(m)); });
  };
  for_each_member([&](std::size_t m) {
    const Particles& particles = bodies[members[m].body].particles;
    position_.set(m, particles.position.at(members[m].slot));
    velocity_.set(m, particles.velocity.at(members[m].slot));
  });
  for_each_member([&](std::size_t m) { got_[m] = add_to(m, bodies, dt); });

  // one after the other: sums of parts would depend on who is in the list
  double energy = 0;
  std::size_t touching = 0;
  for (const Got& got : got_) energy += got.energy, touching += got.touching;
  energy_ = energy;
  touching_ = touching / 2;
}

void ShortRange::note_work(std::span<const TouchingBody> bodies, double dt) {
  if (law_.friction == 0 && law_.damping_ratio == 0) return;
  double friction = 0, restitution = 0;  // [W]
  for (std::size_t m = 0; m < got_.size(); ++m) {
    if (got_[m].touching == 0) continue;
    const NearPairs::Member& member = near_pairs_.members()[m];
    const Particles& particles = bodies[member.body].particles;
    const Vec3d middle = particles.velocity.at(member.slot) + (0.5 * dt / particles.density()) * particles.force_density.at(member.slot);
    friction += dot(got_[m].friction, middle);
    restitution += dot(got_[m].dashpot, middle);
  }
  work_[0] -= friction * dt, work_[1] -= restitution * dt;
}

ShortRange::Got ShortRange::add_to(std::size_t m, std::span<const TouchingBody> bodies, double dt) const {
  const NearPairs::Member& i = near_pairs_.members()[m];
  const TouchingBody& body = bodies[i.body];
  const std::uint8_t* bonds = body.family.bytes(i.slot / byte_lanes);
  const bool exposed = near_pairs_.is_exposed(i);
  const Vec3d place = position_.at(m), speed = velocity_.at(m);
  Got got;
  Vec3d spring{};
  for_each_near(near_pairs_.pairs_of(m), position_, place, [&](std::size_t other, double distance, std::uint32_t bond) {
    const NearPairs::Member& j = near_pairs_.members()[other];
    const Vec3d between = position_.at(other) - place;
    const double length = norm(between);
    if (!(length < distance) || length == 0) return;  // two in one place are pushed nowhere
    if (bond != NearPairs::no_bond && ((bonds[bond] >> (i.slot % byte_lanes)) & 1u)) return;
    if (!exposed && !near_pairs_.is_exposed(j)) return;
    const TouchingBody& its = bodies[j.body];
    const double k = i.body == j.body ? body.stiffness : in_series(body.stiffness, its.stiffness);
    const double mass_i = body.particles.density() * i.volume, mass_j = its.particles.density() * j.volume;
    const TouchForce force = force_of({.overlap = distance - length,
                                       .direction = between / length,
                                       .velocity = velocity_.at(other) - speed,
                                       .stiffness = k * (i.volume * j.volume),
                                       .reduced_mass = mass_i * mass_j / (mass_i + mass_j)},
                                      law_, dt);
    spring += force.spring, got.dashpot += force.dashpot, got.friction += force.friction;
    got.energy += 0.5 * force.energy;
    ++got.touching;
  });
  if (got.touching == 0) return got;
  body.particles.force_density.set(i.slot, body.particles.force_density.at(i.slot) + (spring + got.dashpot + got.friction) / i.volume);
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
