#include "perimpact/self_contact/short_range.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Stiffness of each body for contact with itself and with others. Springs of two bodies are in series. Since the density of others has one stiffness,
/// whatever their bodies, it is that of the softest possible pair.
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
      stiffness_(stiffness_of(bodies)) {
  for (const ContactingBody& body : bodies) {
    yield_pressure_.push_back(body.largest_pressure);
    threshold_.emplace_back(body.particles.slots(), face_.density);
  }
  if (std::ranges::any_of(yield_pressure_, [](double pressure) { return std::isfinite(pressure); }))
    for (const ContactingBody& body : bodies) latest_pressure_.emplace_back(body.particles.slots(), 0.0);
}

void ShortRange::forget() {
  keep_pairs();
  near_pairs_.forget();
}

void ShortRange::add_forces(std::span<const ContactingBody> bodies, double dt) {
  if (near_pairs_.needs_new_list(bodies)) {
    keep_pairs();
    near_pairs_.make(bodies);
    rebuild_derived_pairs();
  }
  near_pairs_.refresh_foreign(bodies);
  const auto members = near_pairs_.members();
  const auto for_each_member = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(members.size()), [&](std::ptrdiff_t m) { f(static_cast<std::size_t>(m)); });
  };
  const auto for_each_own = [&](const auto& f) {
    for_each_member([&](std::size_t m) {
      if (!members[m].is_foreign) f(m);
    });
  };
  for_each_member([&](std::size_t m) {
    if (members[m].is_foreign) {
      const NearPairs::ForeignState& state = near_pairs_.foreign_state(members[m]);
      places_[m].position = state.position, motions_[m].velocity = state.velocity;
    } else {
      const Particles& particles = bodies[members[m].body].particles;
      places_[m].position = particles.position.at(members[m].slot), motions_[m].velocity = particles.velocity.at(members[m].slot);
    }
  });
  for_each_own([&](std::size_t m) { evaluate(m, bodies, dt); });
  near_pairs_.refresh_members<std::array<double, 2>>(
      [&](std::size_t m) {
        return std::array{pressure_[0][m], pressure_[1][m]};
      },
      [&](std::size_t m, const std::array<double, 2>& pressures) {
        for (std::size_t whose = 0; whose < 2; ++whose) pressure_[whose][m] = pressures[whose];
      });
  for_each_own([&](std::size_t m) { pair_sums_[m] = add_to(m, bodies, dt); });

  // members that are not in contact add zeros, so that the sums do not depend on the list; foreign ones do too
  const auto eight_of = [&](std::size_t m) { return members[m].id / byte_lanes; };
  const PairSum sum = exact_sum_over_eights(near_pairs_.ranks(), members.size(), eight_of, [&](std::size_t m) { return pair_sums_[m]; });
  energy_ = sum.energy;
  in_contact_now_ = static_cast<std::size_t>(sum.contacts) / 2;
  work_[0] += sum.friction_dissipation, work_[1] += sum.damped_work, work_[2] += sum.compaction;
}

ShortRange::Eight ShortRange::eight_of(std::size_t m, const std::int32_t* others) const {
  using Pack = NativePack;
  const Vec3d& place = places_[m].position;
  const Pack size(places_[m].size);
  Eight eight;
  eight.near = 0;
  for (std::size_t first = 0; first < byte_lanes; first += lanes<Pack>) {
    const std::int32_t* those = others + first;
    const auto [x, y, z, its] = gather_rows<Pack>(&places_.front().position.x, those);
    const Pack dx = x - Pack(place.x), dy = y - Pack(place.y), dz = z - Pack(place.z);
    const Pack squared = dx * dx + dy * dy + dz * dz, a = distance_of(size, its), reach = Pack(weight_reach) * a;
    const unsigned near = bits_where_greater(reach * reach, squared);
    if (near == 0) continue;
    eight.near |= near << first;
    store(eight.densities.data() + first, weight_of(its, a) * contact_weight(squared / (a * a)));
  }
  return eight;
}

/// The slips of a member's pairs in range, which are stored without gaps, while pairs enter and leave.
class ShortRange::SlipsInRange {
 public:
  SlipsInRange(ShortRange& all, std::size_t member) : all_(all), first_(all.near_pairs_.first_pair(member)), count_(all.near_count_[member]) {}

  /// Eight pairs, in ascending order: bits of those in range `before` and `now`. `to`: pairs in range now, of the eights before.
  void follow(unsigned before, unsigned now, std::size_t to) {
    if (before != now && !moves_) {
      moves_ = true;
      first_kept_ = from_;
      kept_.clear();
      for (std::size_t n = from_; n < count_; ++n) kept_.push_back(all_.slip_of(first_ + n));
    }
    if (!moves_) {
      from_ += static_cast<std::size_t>(std::popcount(before));
      return;
    }
    for_each_bit(before | now, [&](std::size_t lane) {
      const bool was = (before >> lane) & 1u, is = (now >> lane) & 1u;
      if (is) all_.set_slip(first_ + to++, was ? kept_[from_ - first_kept_] : Vec3d{});
      from_ += was;
    });
  }

 private:
  static thread_local std::vector<Vec3d> kept_;  // [m] those from first_kept_ on, as they were

  ShortRange& all_;
  std::size_t first_, count_, from_ = 0, first_kept_ = 0;
  bool moves_ = false;
};
thread_local std::vector<Vec3d> ShortRange::SlipsInRange::kept_;

/// Density around a member, and its pressure.
void ShortRange::evaluate(std::size_t m, std::span<const ContactingBody> bodies, double dt) {
  near_pairs_.insert_broken(m, bodies, [&](std::size_t at, std::size_t last) { insert_pair(at, last); });
  const NearPairs::Member& i = near_pairs_.members()[m];
  const bool exposed = near_pairs_.is_exposed(i);
  const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
  const std::size_t first_pair = near_pairs_.first_pair(m);
  std::int32_t* near_others = near_.data() + first_pair;
  SlipsInRange slips(*this, m);
  const std::size_t own_begin = first_member_[i.body], own_count = first_member_[i.body + 1] - own_begin;
  std::uint32_t count = 0;
  double own = 0, fresh = 0, others = 0;
  for (std::size_t first = 0; first < pairs.count; first += byte_lanes) {
    const std::int32_t* those = pairs.others + first;
    const Eight eight = eight_of(m, those);
    unsigned near = eight.near;
    if (pairs.count - first < byte_lanes) near &= (1u << (pairs.count - first)) - 1u;
    if (!exposed)
      for_each_bit(near, [&](std::size_t lane) {
        if (!near_pairs_.is_exposed(near_pairs_.members()[static_cast<std::size_t>(those[lane])])) near &= ~(1u << lane);
      });
    std::uint8_t& is_near = is_near_[(first_pair + first) / byte_lanes];
    const unsigned entered = near & ~unsigned{is_near};
    if (law_.friction > 0) slips.follow(is_near, near, count);
    is_near = static_cast<std::uint8_t>(near);
    for_each_bit(near, [&](std::size_t lane) {
      near_others[count++] = those[lane];
      (static_cast<std::size_t>(those[lane]) - own_begin < own_count ? own : others) += eight.densities[lane];
    });
    if (entered == 0) continue;
    for_each_bit(entered, [&](std::size_t lane) {
      const std::size_t other = static_cast<std::size_t>(those[lane]);
      if (!(other - own_begin < own_count)) return;
      // pairs that did not move into range, but lost their bond there
      const double reach = weight_reach * distance_of(places_[m].size, places_[other].size);
      const Vec3d between = places_[other].position - places_[m].position, before = between - dt * (motions_[other].velocity - motions_[m].velocity);
      if (squared_norm(before) < reach * reach) fresh += eight.densities[lane];
    });
  }
  near_count_[m] = count;

  // bond failure causes no repulsion: the threshold increases with the density. It decreases with the density, never below that of two faces.
  double& threshold = threshold_of(i);
  const double old = own - fresh;
  threshold = std::max(face_.density, std::min(threshold, old));
  double overlap = std::max(0.0, old - threshold);
  if (yields()) {
    // the threshold yields such that the pressure is the largest; with the mean of the pressures before and after, the balance of leapfrog closes
    double& latest = latest_pressure_[i.body][i.slot];
    const double excess = std::max(0.0, overlap - largest_overlap_[m]);
    threshold += excess, overlap -= excess;
    const double now = density_stiffness_[0][m] * overlap;
    compaction_of_[m] = 0.5 * (latest + now) * excess;
    latest = now;
  }
  if (fresh > 0) threshold = std::max(threshold, own - overlap);

  const double beyond = std::max(0.0, others - face_.density);
  pressure_[0][m] = density_stiffness_[0][m] * overlap, pressure_[1][m] = density_stiffness_[1][m] * beyond;
  energy_of_[m] = 0.5 * (pressure_[0][m] * overlap + pressure_[1][m] * beyond);
}

ShortRange::PairSum ShortRange::add_to(std::size_t m, std::span<const ContactingBody> bodies, double dt) {
  PairSum got;
  const std::size_t count = near_count_[m];
  if (count == 0) return got;
  const NearPairs::Member& i = near_pairs_.members()[m];
  got.energy = energy_of_[m];
  got.compaction = compaction_of_[m];
  Vec3d force{};
  // in the order of body and slot, those of the member's own body are contiguous
  const std::int32_t* near = near_.data() + near_pairs_.first_pair(m);
  const auto before = [&](std::size_t member) {
    return static_cast<std::size_t>(std::lower_bound(near, near + count, static_cast<std::int32_t>(member)) - near);
  };
  const std::size_t begin = bodies.size() > 1 ? before(first_member_[i.body]) : 0, end = bodies.size() > 1 ? before(first_member_[i.body + 1]) : count;
  constexpr std::size_t own = 0, others = 1;
  add_pairs(m, 0, begin, others, bodies, dt, force, got);
  add_pairs(m, begin, end, own, bodies, dt, force, got);
  add_pairs(m, end, count, others, bodies, dt, force, got);
  may_slip_[m] = got.contacts > 0;
  if (got.contacts == 0) return got;
  Particles& particles = bodies[i.body].particles;
  particles.force_density.set(i.slot, particles.force_density.at(i.slot) + force / i.volume);
  return got;
}

void ShortRange::add_pairs(std::size_t m, std::size_t first, std::size_t last, std::size_t whose, std::span<const ContactingBody> bodies, double dt,
                           Vec3d& force, PairSum& got) {
  if (first == last) return;
  using Pack = NativePack;
  const auto members = near_pairs_.members();
  const std::size_t first_pair = near_pairs_.first_pair(m);
  const std::int32_t* near = near_.data() + first_pair;
  const Vec3d &place = places_[m].position, &speed = motions_[m].velocity;
  const Pack mine(pressure_[whose][m]), size(places_[m].size), spring_constant(spring_[whose][m]), volume(motions_[m].volume);
  const bool slides = law_.friction > 0, is_damped = law_.damping_ratio > 0;
  Vec3<Pack> sum{};
  Pack stored(0.0), rubbed(0.0);
  for (; first < last; first += lanes<Pack>) {
    const std::int32_t* those = near + first;
    const std::size_t pair = first_pair + first;  // as slips are numbered
    const unsigned all = last - first < lanes<Pack> ? (1u << (last - first)) - 1u : (1u << lanes<Pack>)-1u;
    const Pack its = gather<Pack>(pressure_[whose].data(), those);
    unsigned pushes = all & bits_where_greater(mine + its, Pack(0.0));
    if (pushes == 0 && !may_slip_[m]) continue;
    const auto [x, y, z, its_size] = gather_rows<Pack>(&places_.front().position.x, those);
    const Vec3<Pack> between{x - Pack(place.x), y - Pack(place.y), z - Pack(place.z)};
    const Pack squared = between.x * between.x + between.y * between.y + between.z * between.z;
    pushes &= bits_where_greater(squared, Pack(0.0));  // coincident particles have no direction of repulsion
    got.contacts += __builtin_popcount(pushes);
    Vec3<Pack> slip{};
    if (slides) {
      for (std::size_t c = 0; c < 3; ++c) slip[c] = load<Pack>(slip_[c].data() + pair);
      const unsigned released = all & ~pushes & bits_where_greater(slip.x * slip.x + slip.y * slip.y + slip.z * slip.z, Pack(0.0));
      for_each_bit(released, [&](std::size_t lane) {
        release_contact(pair + lane, tangential_stiffness(members[m], members[static_cast<std::size_t>(those[lane])]), got);
      });
    }
    if (pushes == 0) continue;
    if (is_damped) {
      for_each_bit(pushes, [&](std::size_t lane) {
        Vec3d its_slip = slides ? slip_of(pair + lane) : Vec3d{};
        const ParticleContactForce pair_contact = force_of_pair(m, static_cast<std::size_t>(those[lane]), whose, bodies, dt, its_slip);
        if (slides) set_slip(pair + lane, its_slip);
        force += pair_contact.normal + pair_contact.friction;
        got.energy += 0.5 * pair_contact.tangential_energy;
        got.friction_dissipation += 0.5 * pair_contact.friction_dissipation, got.damped_work += 0.5 * pair_contact.damped_work;
      });
      continue;
    }
    const Pack a = distance_of(size, its_size), a_squared = a * a;
    const Pack spring = (mine * weight_of(its_size, a) + its * weight_of(size, a)) * (contact_weight_slope(squared / a_squared) / a_squared);  // S/r
    const Pack push = select(pushes, spring);
    sum -= push * between;
    if (!slides) continue;

    // as in force_of()
    const Pack inverse = inverse_square_root(squared);
    const Vec3<Pack> n = inverse * between;
    const auto [vx, vy, vz, its_volume] = gather_rows<Pack>(&motions_.front().velocity.x, those);
    const Vec3<Pack> w{vx - Pack(speed.x), vy - Pack(speed.y), vz - Pack(speed.z)};
    const Vec3<Pack> across = slip - dot(slip, n) * n;
    const Pack length_squared = dot(slip, slip), across_squared = dot(across, across);
    const Pack turned = select(bits_where_greater(across_squared, Pack(0.0)), length_of(length_squared) * inverse_square_root(across_squared));
    const Vec3<Pack> before = turned * across, reached = before + Pack(dt) * (w - dot(n, w) * n);
    const Pack its_spring = whose == 0 ? spring_constant : gather<Pack>(spring_[whose].data(), those);
    const Pack stiffness = Pack(tangential_share) * (Pack(0.5) * (spring_constant + its_spring)) * (volume * its_volume);
    const Pack reached_squared = dot(reached, reached), most = Pack(law_.friction * face_.oblique_share) * (spring * squared * inverse);
    const unsigned exceeds = pushes & bits_where_greater(stiffness * stiffness * reached_squared, most * most);
    Vec3<Pack> after = reached;
    if (exceeds != 0) {
      const Pack kept = select(exceeds, most / stiffness * inverse_square_root(reached_squared)) + select(~exceeds, Pack(1.0));
      after = kept * reached;
    }
    const Pack pull = select(pushes, stiffness);
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + select(pushes, pull * after[c]);
    stored += select(pushes, pull * dot(after, after));
    rubbed += select(pushes, larger(pull * dot(before + after, reached - after), Pack(0.0)));
    if (pushes == (1u << lanes<Pack>)-1u) {
      for (std::size_t c = 0; c < 3; ++c) store(slip_[c].data() + pair, after[c]);
      continue;
    }
    std::array<std::array<double, lanes<Pack>>, 3> slips;
    for (std::size_t c = 0; c < 3; ++c) store(slips[c].data(), after[c]);
    for_each_bit(pushes, [&](std::size_t lane) { set_slip(pair + lane, {slips[0][lane], slips[1][lane], slips[2][lane]}); });
  }
  const auto total = [](Pack pack) {
    std::array<double, lanes<Pack>> of_lane;
    store(of_lane.data(), pack);
    double all = 0;
    for (const double part : of_lane) all += part;
    return all;
  };
  force += Vec3d{total(sum.x), total(sum.y), total(sum.z)};
  // half of each pair belongs to this member
  got.energy += 0.25 * total(stored);
  got.friction_dissipation += 0.25 * total(rubbed);
}

/// A new pair in the order of pairs, not in range; those from there to last - 1 move up by one.
void ShortRange::insert_pair(std::size_t at, std::size_t last) {
  const auto bit = [](std::size_t pair) { return static_cast<std::uint8_t>(1u << pair % byte_lanes); };
  const auto set_near = [&](std::size_t pair, bool near) {
    std::uint8_t& byte = is_near_[pair / byte_lanes];
    byte = static_cast<std::uint8_t>(near ? byte | bit(pair) : byte & ~bit(pair));
  };
  for (std::size_t pair = last; pair > at; --pair) set_near(pair, is_near_[(pair - 1) / byte_lanes] & bit(pair - 1));
  set_near(at, false);
}

/// Dissipates the energy of the tangential spring of a pair out of contact.
void ShortRange::release_contact(std::size_t pair, double stiffness, PairSum& got) {
  got.friction_dissipation += 0.25 * stiffness * squared_norm(slip_of(pair));
  set_slip(pair, {});
}

ParticleContactForce ShortRange::force_of_pair(std::size_t m, std::size_t other, std::size_t whose, std::span<const ContactingBody> bodies, double dt,
                                               Vec3d& slip) const {
  const NearPairs::Member &i = near_pairs_.members()[m], &j = near_pairs_.members()[other];
  const Vec3d between = places_[other].position - places_[m].position;
  const double length = norm(between), distance = distance_of(i.size, j.size), q = length / distance;
  const double slope = q * contact_weight_slope(q * q) / distance, weight_i = weight_of(i.size, distance), weight_j = weight_of(j.size, distance);
  ParticleContact pair_contact{.direction = between / length,
                               .velocity = motions_[other].velocity - motions_[m].velocity,
                               .spring = (pressure_[whose][m] * weight_j + pressure_[whose][other] * weight_i) * slope,
                               .stiffness = 0,
                               .reduced_mass = 0,
                               .tangential_stiffness = tangential_stiffness(i, j),
                               .oblique_share = face_.oblique_share};
  if (law_.damping_ratio > 0) {
    const double of_i = density_stiffness_[whose][m] * (weight_j * weight_j), of_j = density_stiffness_[whose][other] * (weight_i * weight_i);
    const double mass_i = bodies[i.body].particles.density() * i.volume, mass_j = bodies[j.body].particles.density() * j.volume;
    pair_contact.stiffness = (of_i + of_j) * (slope * slope);
    pair_contact.reduced_mass = mass_i * mass_j / (mass_i + mass_j);
  }
  return force_of(pair_contact, law_, dt, slip);
}

double ShortRange::tangential_stiffness(const NearPairs::Member& i, const NearPairs::Member& j) const {
  const std::size_t whose = i.body == j.body ? 0 : 1;
  return tangential_share * (0.5 * (stiffness_[i.body][whose] + stiffness_[j.body][whose])) * (i.volume * j.volume);
}

/// Stores the state of the pairs, before the list is rebuilt or the state is visited.
void ShortRange::keep_pairs() {
  if (is_kept_) return;
  is_kept_ = true;
  kept_ = {};
  const auto members = near_pairs_.members();
  if (is_near_.size() * byte_lanes < near_pairs_.pair_count()) return;  // none has been evaluated
  for (std::size_t m = 0; m < members.size(); ++m) {
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
    std::size_t next = near_pairs_.first_pair(m);  // in range
    for_each_near(m, [&](std::size_t n) {
      const std::size_t pair = next++;
      const std::uint64_t id = members[m].id, other = members[static_cast<std::size_t>(pairs.others[n])].id;
      if (other < id) return;
      kept_.ends.push_back(id), kept_.ends.push_back(other);
      if (law_.friction > 0)
        for (std::size_t c = 0; c < 3; ++c) kept_.slips.push_back(slip_[c][pair]);
    });
  }
}

/// After a restart, from a state of all ranks.
void ShortRange::discard_pairs_of_others() {
  if (near_pairs_.ranks().size() == 1) return;
  const Kept all = std::exchange(kept_, {});
  for (std::size_t pair = 0; pair < all.size(); ++pair) {
    if (near_pairs_.owner_of(all.ends[2 * pair]) != near_pairs_.ranks().rank()) continue;
    kept_.ends.insert(kept_.ends.end(), {all.ends[2 * pair], all.ends[2 * pair + 1]});
    const Vec3d slip = all.slip(pair);
    if (!all.slips.empty()) kept_.slips.insert(kept_.slips.end(), {slip.x, slip.y, slip.z});
  }
}

/// Assigns the stored state to the pairs of a new list.
void ShortRange::rebuild_derived_pairs() {
  const auto members = near_pairs_.members();
  places_.assign(members.size(), {});
  motions_.assign(members.size(), {});
  for (auto* numbers : {&pressure_[0], &pressure_[1], &spring_[0], &spring_[1], &density_stiffness_[0], &density_stiffness_[1]})
    numbers->assign(members.size(), 0);
  largest_overlap_.assign(members.size(), 0);
  first_member_.assign(stiffness_.size() + 1, members.size());
  for (std::size_t m = members.size(); m-- > 0;) {
    const NearPairs::Member& i = members[m];
    places_[m].size = i.size, motions_[m].volume = i.volume;
    for (std::size_t whose = 0; whose < 2; ++whose)
      spring_[whose][m] = stiffness_[i.body][whose],
      density_stiffness_[whose][m] = density_stiffness(face_, stiffness_[i.body][whose], i.volume, law_.distance_ratio * i.size);
    largest_overlap_[m] = density_pressure(face_, yield_pressure_[i.body], i.volume, i.size, law_.distance_ratio * i.size) / density_stiffness_[0][m];
    first_member_[i.body] = m;
  }
  for (std::size_t b = stiffness_.size(); b-- > 0;) first_member_[b] = std::min(first_member_[b], first_member_[b + 1]);  // of a body without members
  energy_of_.assign(members.size(), 0);
  compaction_of_.assign(members.size(), 0);
  pair_sums_.assign(members.size(), {});
  near_count_.assign(members.size(), 0);
  may_slip_.assign(members.size(), law_.friction > 0);
  const std::size_t count = near_pairs_.pair_count();
  resize_to(near_, count + byte_lanes);
  std::fill(near_.begin(), near_.end(), 0);  // packs of eight are read
  is_near_.assign(count / byte_lanes, 0);
  if (law_.friction > 0) {
    for (fccda::AlignedVector<double>& component : slip_) {
      resize_to(component, count + byte_lanes);
      std::fill(component.begin(), component.end(), 0.0);
    }
  }

  reset_particles_out_of_range();
  restore_pairs();
}

void ShortRange::reset_particles_out_of_range() {
  const auto reset = [&](std::vector<std::vector<double>>& of_bodies, double value) {
    std::vector<double> kept;
    for (const NearPairs::Member& i : near_pairs_.members()) kept.push_back(i.is_foreign ? 0 : of_bodies[i.body][i.slot]);
    for (std::vector<double>& of_body : of_bodies) std::ranges::fill(of_body, value);
    for (std::size_t m = 0; m < kept.size(); ++m)
      if (const NearPairs::Member& i = near_pairs_.members()[m]; !i.is_foreign) of_bodies[i.body][i.slot] = kept[m];
  };
  reset(threshold_, face_.density);
  if (yields()) reset(latest_pressure_, 0);
}

void ShortRange::restore_pairs() {
  const auto restore = [&](std::uint64_t from, std::uint64_t to, const Vec3d& slip) {
    const auto m = near_pairs_.member_of_id(from), other = near_pairs_.member_of_id(to);
    if (!m || !other) return;
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(*m);
    const std::int32_t* end = pairs.others + pairs.count;
    const std::int32_t* found = std::lower_bound(pairs.others, end, static_cast<std::int32_t>(*other));
    if (found == end || *found != static_cast<std::int32_t>(*other)) return;
    const std::size_t pair = near_pairs_.first_pair(*m) + static_cast<std::size_t>(found - pairs.others);
    is_near_[pair / byte_lanes] |= static_cast<std::uint8_t>(1u << pair % byte_lanes);
    if (law_.friction > 0) set_slip(pair, slip);
  };
  ListsByRank<SentPair> sent;
  for (std::size_t pair = 0; pair < kept_.size(); ++pair) {
    const std::array<std::uint64_t, 2> ends = {kept_.ends[2 * pair], kept_.ends[2 * pair + 1]};
    restore(ends[0], ends[1], kept_.slip(pair)), restore(ends[1], ends[0], -kept_.slip(pair));
    if (const int owner = near_pairs_.owner_of(ends[1]); owner != near_pairs_.ranks().rank()) sent[owner].push_back({ends, kept_.slip(pair)});
  }
  for (const auto& [from, pairs] : exchange_lists(near_pairs_.ranks(), sent))
    for (const SentPair& pair : pairs) restore(pair.ends[1], pair.ends[0], -pair.slip);
  // slips lie in the places of their pairs in the list, and move to those of the pairs in range
  fccda::parallel_for(static_cast<std::ptrdiff_t>(near_count_.size()), [&](std::ptrdiff_t member) {
    const auto m = static_cast<std::size_t>(member);
    const std::size_t first = near_pairs_.first_pair(m);
    for_each_near(m, [&](std::size_t number) {
      const std::size_t to = first + near_count_[m]++;
      if (law_.friction > 0) set_slip(to, slip_of(first + number));
    });
  });
  kept_ = {};
  is_kept_ = false;
}

/// Calls f(number) for the pairs of a member in range.
template <class F>
void ShortRange::for_each_near(std::size_t m, const F& f) const {
  const std::uint8_t* bits = is_near_.data() + near_pairs_.first_pair(m) / byte_lanes;
  for (std::size_t first = 0; first < near_pairs_.pairs_of(m).count; first += byte_lanes)
    for_each_bit(bits[first / byte_lanes], [&](std::size_t lane) { f(first + lane); });
}

ShortRange::Bound ShortRange::bound(std::span<const ContactingBody> bodies, std::size_t b) const {
  struct Largest {
    double volume = 0, mass = 0;
  };
  const auto largest = [](const Particles& particles) {
    Largest found;
    for (const std::uint32_t slot : particles.slot_of()) found = {std::max(found.volume, particles.volume(slot)), std::max(found.mass, particles.mass(slot))};
    return Largest{particles.share().ranks().max(found.volume), particles.share().ranks().max(found.mass)};
  };
  const Largest own = largest(bodies[b].particles);
  Bound bound{};
  for (std::size_t other = 0; other < bodies.size(); ++other) {
    const Largest its = largest(bodies[other].particles);
    const double k = in_series(bodies[b].stiffness, bodies[other].stiffness);
    const double mass = own.mass * its.mass / (own.mass + its.mass);
    bound.stiffness = std::max(bound.stiffness, most_in_contact * k * its.volume);
    bound.damping = std::max(bound.damping, most_in_contact * 2 * law_.damping_ratio * std::sqrt(k * its.volume * mass / own.volume));
  }
  return bound;
}

}  // namespace perimpact
