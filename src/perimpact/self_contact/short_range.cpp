#include "perimpact/self_contact/short_range.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Calls visit(number, other, reach, bond) for those of the pairs that are nearer than they reach, but for rounding, in order.
template <class Visit>
void for_each_near(const NearPairs::Pairs& pairs, const VectorArray& position, const Vec3d& place, const Visit& visit) {
  using Pack = NativePack;
  const std::array<const double*, 3> x = position.pointers();
  const Vec3<Pack> at{Pack(place.x), Pack(place.y), Pack(place.z)};
  for (std::size_t first = 0; first < pairs.count; first += lanes<Pack>) {
    const std::int32_t* others = pairs.others + first;
    const Vec3<Pack> between{gather<Pack>(x[0], others) - at.x, gather<Pack>(x[1], others) - at.y, gather<Pack>(x[2], others) - at.z};
    const Pack squared = fused_multiply_add(between.z, between.z, fused_multiply_add(between.y, between.y, between.x * between.x));
    const Pack distance = load<Pack>(pairs.distances + first);
    constexpr double rounding = 1 + 1e-12;
    unsigned near = bits_where_greater(Pack(rounding) * distance * distance, squared);
    if (pairs.count - first < lanes<Pack>) near &= (1u << (pairs.count - first)) - 1u;
    for (; near != 0; near &= near - 1) {
      const std::size_t lane = static_cast<std::size_t>(__builtin_ctz(near));
      visit(first + lane, static_cast<std::size_t>(others[lane]), pairs.distances[first + lane], pairs.bonds[first + lane]);
    }
  }
}

/// Of each body, against itself and against others. Springs of two bodies are in series; since a density has one stiffness, whoever its particles belong to, it
/// is that of the softest pair that the body can be one of.
std::vector<std::array<double, 2>> stiffness_of(std::span<const ContactingBody> bodies) {
  std::vector<std::array<double, 2>> all;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    double softest = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < bodies.size(); ++other)
      if (other != b) softest = std::min(softest, in_series(bodies[b].stiffness, bodies[other].stiffness));
    all.push_back({bodies[b].stiffness, bodies.size() > 1 ? softest : bodies[b].stiffness});
  }
  return all;
}

}  // namespace

ShortRange::ShortRange(const ShortRangeLaw& law, std::span<const ContactingBody> bodies)
    : law_(law),
      face_(bodies.front().particles.is_plane() ? face_in_plane : face_in_space),
      is_plane_(bodies.front().particles.is_plane()),
      near_pairs_(law, bodies),
      stiffness_(stiffness_of(bodies)),
      threshold_(near_pairs_.particle_count(), face_.density) {}

void ShortRange::forget() {
  keep_pairs();
  near_pairs_.forget();
}

void ShortRange::add_forces(std::span<const ContactingBody> bodies, double dt) {
  if (near_pairs_.needs_new_list(bodies)) {
    keep_pairs();
    near_pairs_.make(bodies);
    take_up_pairs();
  }
  const auto members = near_pairs_.members();
  const auto for_each_member = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(members.size()), [&](std::ptrdiff_t m) { f(static_cast<std::size_t>(m)); });
  };
  ++evaluation_;
  for_each_member([&](std::size_t m) {
    const Particles& particles = bodies[members[m].body].particles;
    position_.set(m, particles.position.at(members[m].slot));
    velocity_.set(m, particles.velocity.at(members[m].slot));
  });
  for_each_member([&](std::size_t m) { look_at(m, bodies, dt); });
  for_each_member([&](std::size_t m) { pair_sums_[m] = add_to(m, bodies, dt); });

  // one after the other: sums of parts would depend on who is in the list
  double energy = 0;
  std::array<double, 2> work{};
  std::size_t touching = 0;
  for (const PairSum& got : pair_sums_) energy += got.energy, work[0] += got.friction_dissipation, work[1] += got.damped_work, touching += got.touching;
  energy_ = energy;
  in_contact_now_ = touching / 2;
  for (std::size_t k = 0; k < 2; ++k) work_[k] += work[k];
}

/// The density around a member, and what it presses with.
void ShortRange::look_at(std::size_t m, std::span<const ContactingBody> bodies, double dt) {
  const NearPairs::Member& i = near_pairs_.members()[m];
  const ContactingBody& body = bodies[i.body];
  const std::uint8_t* bonds = body.family.bytes(i.slot / byte_lanes);
  const bool exposed = near_pairs_.is_exposed(i);
  const Vec3d place = position_.at(m), speed = velocity_.at(m);
  const std::size_t first_pair = near_pairs_.first_pair(m);
  std::uint32_t near = 0;
  double own = 0, fresh = 0, others = 0;
  for_each_near(near_pairs_.pairs_of(m), position_, place, [&](std::size_t number, std::size_t other, double reach, std::uint32_t bond) {
    const NearPairs::Member& j = near_pairs_.members()[other];
    const Vec3d between = position_.at(other) - place;
    const double squared = squared_norm(between);
    if (!(squared < reach * reach)) return;
    if (bond != NearPairs::no_bond && ((bonds[bond] >> (i.slot % byte_lanes)) & 1u)) return;
    if (!exposed && !near_pairs_.is_exposed(j)) return;
    const std::size_t pair = first_pair + number;
    near_[first_pair + near++] = static_cast<std::uint32_t>(number);
    const bool was_near = seen_[pair] + 1 == evaluation_;
    seen_[pair] = evaluation_;
    if (!was_near && law_.friction > 0) slip_[pair] = {};
    const double distance = reach / weight_reach;
    const double density = weight_of(j.size, distance) * contact_weight(squared / (distance * distance));
    if (i.body != j.body) {
      others += density;
      return;
    }
    own += density;
    // that did not come near, but lost its bond where it is
    if (!was_near && squared_norm(between - dt * (velocity_.at(other) - speed)) < reach * reach) fresh += density;
  });
  near_count_[m] = near;

  // a lost bond pushes nobody: the threshold rises by as much as the density. It falls with the density, never below that of two faces.
  double& threshold = threshold_[i.particle];
  const double old = own - fresh;
  threshold = std::max(face_.density, std::min(threshold, old));
  const double overlap = std::max(0.0, old - threshold);
  if (fresh > 0) threshold = std::max(threshold, own - overlap);

  const double a = law_.distance_ratio * i.size, beyond = std::max(0.0, others - face_.density);
  const double its_own = density_stiffness(face_, stiffness_[i.body][0], i.volume, a), of_others = density_stiffness(face_, stiffness_[i.body][1], i.volume, a);
  pressure_[m] = {its_own * overlap, of_others * beyond};
  energy_of_[m] = 0.5 * (its_own * (overlap * overlap) + of_others * (beyond * beyond));
}

ShortRange::PairSum ShortRange::add_to(std::size_t m, std::span<const ContactingBody> bodies, double dt) {
  PairSum got;
  if (near_count_[m] == 0) return got;
  const NearPairs::Member& i = near_pairs_.members()[m];
  const ContactingBody& body = bodies[i.body];
  const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
  const std::size_t first_pair = near_pairs_.first_pair(m);
  const Vec3d place = position_.at(m), speed = velocity_.at(m);
  const Pressure& mine = pressure_[m];
  got.energy = energy_of_[m];
  Vec3d force{};
  for (std::uint32_t n = 0; n < near_count_[m]; ++n) {
    const std::size_t number = near_[first_pair + n], other = static_cast<std::size_t>(pairs.others[number]);
    const NearPairs::Member& j = near_pairs_.members()[other];
    const bool one_body = i.body == j.body;
    const double my = one_body ? mine.own : mine.others, its = one_body ? pressure_[other].own : pressure_[other].others;
    Vec3d* slip = law_.friction > 0 ? &slip_[first_pair + number] : nullptr;
    const Vec3d between = position_.at(other) - place;
    const double length = norm(between);
    if ((my == 0 && its == 0) || length == 0) {  // two in one place are pushed nowhere
      if (slip && squared_norm(*slip) > 0) {     // what the spring held when the pressure ended
        const double k = tangential_stiffness(i, j);
        got.friction_dissipation += 0.25 * k * squared_norm(*slip);
        *slip = {};
      }
      continue;
    }
    const double distance = pairs.distances[number] / weight_reach, q = length / distance;
    const double slope = q * contact_weight_slope(q * q) / distance, weight_i = weight_of(i.size, distance), weight_j = weight_of(j.size, distance);
    const std::size_t whose = one_body ? 0 : 1;
    const double a_i = law_.distance_ratio * i.size, a_j = law_.distance_ratio * j.size;
    const double of_i = density_stiffness(face_, stiffness_[i.body][whose], i.volume, a_i) * (weight_j * weight_j),
                 of_j = density_stiffness(face_, stiffness_[j.body][whose], j.volume, a_j) * (weight_i * weight_i);
    const double mass_i = body.particles.density() * i.volume, mass_j = bodies[j.body].particles.density() * j.volume;
    Vec3d none{};
    const TouchForce touch = force_of({.direction = between / length,
                                       .velocity = velocity_.at(other) - speed,
                                       .spring = (my * weight_j + its * weight_i) * slope,
                                       .stiffness = (of_i + of_j) * (slope * slope),
                                       .reduced_mass = mass_i * mass_j / (mass_i + mass_j),
                                       .tangential_stiffness = tangential_stiffness(i, j),
                                       .oblique_share = face_.oblique_share},
                                      law_, dt, slip ? *slip : none);
    force += touch.normal + touch.friction;
    got.energy += 0.5 * touch.tangential_energy;
    got.friction_dissipation += 0.5 * touch.friction_dissipation, got.damped_work += 0.5 * touch.damped_work;
    ++got.touching;
  }
  if (got.touching == 0) return got;
  body.particles.force_density.set(i.slot, body.particles.force_density.at(i.slot) + force / i.volume);
  return got;
}

double ShortRange::tangential_stiffness(const NearPairs::Member& i, const NearPairs::Member& j) const {
  const std::size_t whose = i.body == j.body ? 0 : 1;
  return tangential_share * (0.5 * (stiffness_[i.body][whose] + stiffness_[j.body][whose])) * (i.volume * j.volume);
}

/// Of the pairs in the list, before it is made anew or looked at from outside.
void ShortRange::keep_pairs() {
  if (is_kept_) return;
  is_kept_ = true;
  kept_ = {};
  const auto members = near_pairs_.members();
  if (seen_.size() < near_pairs_.pair_count()) return;  // none has been evaluated
  for (std::size_t m = 0; m < members.size(); ++m) {
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
    const std::size_t first = near_pairs_.first_pair(m);
    for (std::size_t n = 0; n < pairs.count; ++n) {
      const std::uint32_t particle = members[m].particle, other = members[static_cast<std::size_t>(pairs.others[n])].particle;
      if (seen_[first + n] != evaluation_ || other < particle) continue;
      kept_.ends.push_back(particle), kept_.ends.push_back(other);
      if (law_.friction > 0)
        for (std::size_t c = 0; c < 3; ++c) kept_.slips.push_back(slip_[first + n][c]);
    }
  }
}

/// Gives a new list what was known of its pairs.
void ShortRange::take_up_pairs() {
  const auto members = near_pairs_.members();
  position_ = velocity_ = VectorArray(members.size(), 0);
  pressure_.assign(members.size(), {});
  energy_of_.assign(members.size(), 0);
  pair_sums_.assign(members.size(), {});
  near_count_.assign(members.size(), 0);
  const std::size_t count = near_pairs_.pair_count();
  resize_to(near_, count);
  resize_to(seen_, count);
  std::fill(seen_.begin(), seen_.end(), evaluation_ - 1);
  if (law_.friction > 0) {
    resize_to(slip_, count);
    std::fill(slip_.begin(), slip_.end(), Vec3d{});
  }

  std::vector<std::uint32_t> member_of(threshold_.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::size_t m = 0; m < members.size(); ++m) member_of[members[m].particle] = static_cast<std::uint32_t>(m);
  for (std::size_t p = 0; p < threshold_.size(); ++p)
    if (member_of[p] == std::numeric_limits<std::uint32_t>::max()) threshold_[p] = face_.density;  // nothing is near it
  const auto give = [&](std::uint32_t from, std::uint32_t to, const Vec3d& slip) {
    const std::uint32_t m = member_of[from], other = member_of[to];
    if (m == std::numeric_limits<std::uint32_t>::max() || other == std::numeric_limits<std::uint32_t>::max()) return;
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
    const std::int32_t* end = pairs.others + pairs.count;
    const std::int32_t* found = std::lower_bound(pairs.others, end, static_cast<std::int32_t>(other));
    if (found == end || *found != static_cast<std::int32_t>(other)) return;
    const std::size_t pair = near_pairs_.first_pair(m) + static_cast<std::size_t>(found - pairs.others);
    seen_[pair] = evaluation_;
    if (law_.friction > 0) slip_[pair] = slip;
  };
  for (std::size_t k = 0; 2 * k < kept_.ends.size(); ++k) {
    const Vec3d slip = law_.friction > 0 ? Vec3d{kept_.slips[3 * k], kept_.slips[3 * k + 1], kept_.slips[3 * k + 2]} : Vec3d{};
    give(kept_.ends[2 * k], kept_.ends[2 * k + 1], slip), give(kept_.ends[2 * k + 1], kept_.ends[2 * k], -slip);
  }
  kept_ = {};
  is_kept_ = false;
}

ShortRange::Bound ShortRange::bound(std::span<const ContactingBody> bodies, std::size_t b) const {
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
