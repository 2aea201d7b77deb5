/// Kernels of the short-range force: what one particle sums over its pairs, on packs of these (law: short_range_law.hpp). For host and device.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "perimpact/self_contact/short_range_law.hpp"
#include "perimpact/self_contact/short_range_view.hpp"

namespace perimpact {

/// Moves the pairs of a member whose bonds have broken to those without a bond. Returns whether there was room for all of them; if not, call it again with more
/// room. `is_intact(row)`: the bond of a row of its family.
template <class IsIntact>
FCCDA_HD bool insert_broken_pairs(const ShortRangeView& view, std::size_t m, const IsIntact& is_intact) {
  const PairsView& pairs = view.pairs;
  const std::size_t first = pairs.first_pair[m], end = first + pairs.counts[m], room = view.near_room[m];
  std::uint32_t& unbonded = pairs.unbonded_counts[m];
  const auto is_near = [&](std::size_t pair) { return (view.is_near[pair / fccda::byte_lanes] >> (pair % fccda::byte_lanes)) & 1u; };
  const auto set_near = [&](std::size_t pair, unsigned near) {
    std::uint8_t& byte = view.is_near[pair / fccda::byte_lanes];
    byte = static_cast<std::uint8_t>((byte & ~(1u << (pair % fccda::byte_lanes))) | (near << (pair % fccda::byte_lanes)));
  };
  for (std::size_t pair = first + unbonded; pair < end; ++pair) {
    if (is_intact(pairs.bonds[pair])) continue;
    if (unbonded == room) return false;
    const std::int32_t other = pairs.others[pair];
    // in the order of members; the bonded pairs before it move up by one as well
    std::size_t at = pair;
    for (; at > first + unbonded; --at) pairs.others[at] = pairs.others[at - 1], pairs.bonds[at] = pairs.bonds[at - 1];
    for (; at > first && pairs.others[at - 1] > other; --at) {
      pairs.others[at] = pairs.others[at - 1], pairs.bonds[at] = pairs.bonds[at - 1];
      set_near(at, is_near(at - 1));
    }
    pairs.others[at] = other, pairs.bonds[at] = no_bond;
    set_near(at, 0);
    ++unbonded;
  }
  return true;
}

/// f(lane) for each set bit of the lanes of a pack. Of one lane its number is a constant, so that on a device arrays of lanes are registers.
template <class Pack, class F>
FCCDA_HD void for_each_lane(unsigned bits, const F& f) {
  if constexpr (fccda::lanes<Pack> == 1) {
    if (bits & 1u) f(std::size_t{0});
  } else {
    fccda::for_each_bit(bits, f);
  }
}

/// The pairs of a pack, from positions alone: bits of those within the support of the weight function. Their contributions to the density are written to
/// `densities`; those of others are undefined.
template <class Pack>
FCCDA_HD unsigned near_of_pack(const PlaceOfMember* places, const PairScale& scale, const PlaceOfMember& place, const std::int32_t* others, double* densities) {
  using namespace fccda;
  const auto [x, y, z, its] = gather_rows<Pack>(&places->position.x, others);
  const Pack dx = x - Pack(place.position.x), dy = y - Pack(place.position.y), dz = z - Pack(place.position.z), size(place.size);
  const Pack squared = dx * dx + dy * dy + dz * dz, a = scale.distance_of(size, its), reach = Pack(weight_reach) * a;
  const unsigned near = bits_where_greater(reach * reach, squared);
  if (near != 0) store(densities, scale.weight_of(its, a) * contact_weight(squared / (a * a)));
  return near;
}

/// Moves the slips of a member as pairs enter and leave: of eight pairs, in ascending order, bits of those in range `before` and `now`. `first`: place of the
/// first slip of the member; `count`: slips stored; `at`: pairs in range now, of the eights before. Returns the slips stored then.
FCCDA_HD inline std::size_t move_slips(const ShortRangeView& view, std::size_t first, std::size_t count, unsigned before, unsigned now, std::size_t at) {
  if (before == now) return count;
  for (std::size_t lane = 0; lane < fccda::byte_lanes; ++lane) {
    const bool was = (before >> lane) & 1u, is = (now >> lane) & 1u;
    if (was && !is) {
      --count;
      for (std::size_t n = first + at; n < first + count; ++n) view.set_slip(n, view.slip_of(n + 1));
    } else if (is && !was) {
      for (std::size_t n = first + count; n > first + at; --n) view.set_slip(n, view.slip_of(n - 1));
      view.set_slip(first + at, {});
      ++count;
    }
    at += is;
  }
  return count;
}

/// Density around a member, and its pressure.
template <class Pack>
FCCDA_HD void evaluate_density(const ShortRangeView& view, std::size_t m) {
  using namespace fccda;
  const std::size_t first_pair = view.pairs.first_pair[m], pair_count = view.pairs.unbonded_counts[m];
  // without a pair now nor in the evaluation before, all that is written below is written already
  if (pair_count == 0 && view.threshold[m] == view.face.density && !(view.yields && view.latest_pressure[m] > 0)) return;
  // copies, which stay in registers while bytes are written
  const PairScale scale = view.scale;
  const PlaceOfMember *const places = view.places, place = places[m];
  const std::int32_t* const pairs = view.pairs.others + first_pair;
  const std::uint8_t* const is_exposed = view.pairs.is_exposed;
  const std::size_t first_near = view.first_near[m];
  std::int32_t* const near_others = view.near + first_near;
  std::uint8_t* const is_near = view.is_near + first_pair / byte_lanes;
  const bool exposed = is_exposed[m] != 0, slides = view.slides();
  const std::uint32_t body = view.body[m];
  const std::size_t own_begin = view.first_member[body], own_count = view.first_member[body + 1] - own_begin;
  const auto is_own = [&](std::int32_t other) { return static_cast<std::size_t>(other) - own_begin < own_count; };
  std::size_t slips = view.near_count[m];
  std::uint32_t count = 0;
  double own = 0, fresh = 0, others = 0;
  for (std::size_t first = 0; first < pair_count; first += byte_lanes) {
    const unsigned all = pair_count - first < byte_lanes ? (1u << (pair_count - first)) - 1u : 0xffu, before = is_near[first / byte_lanes];
    const std::uint32_t near_before = count;
    unsigned now = 0;
    for (std::size_t lane = 0; lane < byte_lanes && (all >> lane) != 0; lane += lanes<Pack>) {
      const std::int32_t* those = pairs + first + lane;
      alignas(64) std::array<double, lanes<Pack>> densities;
      unsigned near = (all >> lane) & near_of_pack<Pack>(places, scale, place, those, densities.data());
      if (!exposed)
        for_each_lane<Pack>(near, [&](std::size_t n) {
          if (is_exposed[those[n]] == 0) near &= ~(1u << n);
        });
      if (near == 0) continue;
      now |= near << lane;
      for_each_lane<Pack>(near, [&](std::size_t n) {
        near_others[count++] = those[n];
        const bool of_own = is_own(those[n]);
        own += of_own ? densities[n] : 0.0, others += of_own ? 0.0 : densities[n];
      });
      const unsigned entered = near & ~(before >> lane);
      if (entered == 0) continue;
      for_each_lane<Pack>(entered, [&](std::size_t n) {
        if (!is_own(those[n])) return;
        // pairs that did not move into range, but lost their bond there
        const PlaceOfMember& other = places[those[n]];
        const double reach = weight_reach * scale.distance_of(place.size, other.size);
        const Vec3d earlier = other.position - place.position - view.dt * (view.motions[those[n]].velocity - view.motions[m].velocity);
        if (squared_norm(earlier) < reach * reach) fresh += densities[n];
      });
    }
    if (slides) slips = move_slips(view, first_near, slips, before, now, near_before);
    is_near[first / byte_lanes] = static_cast<std::uint8_t>(now);
  }
  view.near_count[m] = count;

  // bond failure causes no repulsion: the threshold increases with the density. It decreases where fragments part, never below that of two faces.
  double threshold = view.threshold[m];
  const double old = own - fresh;
  const double parted = old + remembered_opening * view.face.slope;
  threshold = larger(view.face.density, threshold < parted ? threshold : parted);
  double overlap = larger(old - threshold, 0.0);
  if (view.yields) {
    // the threshold yields such that the pressure is the largest; with the mean of the pressures before and after, the balance of leapfrog closes
    double& latest = view.latest_pressure[m];
    const double excess = larger(overlap - view.largest_overlap[m], 0.0);
    threshold += excess, overlap -= excess;
    const double now = view.density_stiffness[0][m] * overlap;
    view.compaction[m] = 0.5 * (latest + now) * excess;
    latest = now;
  }
  if (fresh > 0) threshold = larger(threshold, own - overlap);
  view.threshold[m] = threshold;

  const double beyond = larger(others - view.face.density, 0.0);
  const double pressure = view.density_stiffness[0][m] * overlap, pressure_of_others = view.density_stiffness[1][m] * beyond;
  view.pressure[0][m] = pressure, view.pressure[1][m] = pressure_of_others;
  view.energy[m] = 0.5 * (pressure * overlap + pressure_of_others * beyond);
}

/// Force of one pair with a dashpot.
FCCDA_HD inline ParticleContactForce force_of_pair(const ShortRangeView& view, std::size_t m, std::size_t other, std::size_t whose, Vec3d& slip) {
  const double *const pressure = view.of(view.pressure, whose), *const stiffness = view.of(view.density_stiffness, whose);
  const double size_i = view.places[m].size, size_j = view.places[other].size, volume_i = view.motions[m].volume, volume_j = view.motions[other].volume;
  const Vec3d between = view.places[other].position - view.places[m].position;
  const double length = std::sqrt(dot(between, between)), distance = view.scale.distance_of(size_i, size_j), q = length / distance;
  const double slope = q * contact_weight_slope(q * q) / distance, weight_i = view.scale.weight_of(size_i, distance),
               weight_j = view.scale.weight_of(size_j, distance);
  ParticleContact pair_contact{.direction = between / length,
                               .velocity = view.motions[other].velocity - view.motions[m].velocity,
                               .spring = (pressure[m] * weight_j + pressure[other] * weight_i) * slope,
                               .stiffness = 0,
                               .reduced_mass = 0,
                               .tangential_stiffness = view.tangential_stiffness(m, other),
                               .oblique_share = view.face.oblique_share};
  if (view.law.damping_ratio > 0) {
    const double of_i = stiffness[m] * (weight_j * weight_j), of_j = stiffness[other] * (weight_i * weight_i);
    const double mass_i = view.mass_density[view.body[m]] * volume_i, mass_j = view.mass_density[view.body[other]] * volume_j;
    pair_contact.stiffness = (of_i + of_j) * (slope * slope);
    pair_contact.reduced_mass = mass_i * mass_j / (mass_i + mass_j);
  }
  return force_of(pair_contact, view.law, view.dt, slip);
}

/// Dissipates the energy of the tangential spring of a pair out of contact.
FCCDA_HD inline void release_contact(const ShortRangeView& view, std::size_t pair, double stiffness, PairSum& sum) {
  sum.friction_dissipation += 0.25 * stiffness * squared_norm(view.slip_of(pair));
  view.set_slip(pair, {});
}

/// Adds the contributions of the near pairs first … last - 1 of a member, all with its own body (`whose` 0) or all with others (1).
template <class Pack>
FCCDA_HD void add_pairs(const ShortRangeView& view, std::size_t m, std::size_t first, std::size_t last, std::size_t whose, Vec3d& force, PairSum& got) {
  using namespace fccda;
  if (first == last) return;
  const std::size_t first_near = view.first_near[m];
  const std::int32_t* near = view.near + first_near;
  const Vec3d place = view.places[m].position, speed = view.motions[m].velocity;
  const double *const pressure = view.of(view.pressure, whose), *const spring_of = view.of(view.spring, whose);
  const Pack mine(pressure[m]), size(view.places[m].size), spring_constant(spring_of[m]), volume(view.motions[m].volume);
  const bool slides = view.slides(), is_damped = view.law.damping_ratio > 0, may_slip = view.may_slip[m] != 0;
  Vec3<Pack> sum{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack stored(0.0), rubbed(0.0);
  bool is_loaded = false;  // most members near others are not
  for (; first < last; first += lanes<Pack>) {
    const std::int32_t* those = near + first;
    const std::size_t pair = first_near + first;
    const unsigned all = last - first < lanes<Pack> ? (1u << (last - first)) - 1u : (1u << lanes<Pack>)-1u;
    const Pack its = gather<Pack>(pressure, those);
    unsigned pushes = all & bits_where_greater(mine + its, Pack(0.0));
    if (pushes == 0 && !may_slip) continue;
    is_loaded = true;
    const auto [x, y, z, its_size] = gather_rows<Pack>(&view.places->position.x, those);
    const Vec3<Pack> between{x - Pack(place.x), y - Pack(place.y), z - Pack(place.z)};
    const Pack squared = between.x * between.x + between.y * between.y + between.z * between.z;
    pushes &= bits_where_greater(squared, Pack(0.0));  // coincident particles have no direction of repulsion
    got.contacts += std::popcount(pushes);
    Vec3<Pack> slip{Pack(0.0), Pack(0.0), Pack(0.0)};
    if (slides) {
      for (std::size_t c = 0; c < 3; ++c) slip[c] = load<Pack>(view.slip[c] + pair);
      const unsigned released = all & ~pushes & bits_where_greater(slip.x * slip.x + slip.y * slip.y + slip.z * slip.z, Pack(0.0));
      for_each_lane<Pack>(
          released, [&](std::size_t lane) { release_contact(view, pair + lane, view.tangential_stiffness(m, static_cast<std::size_t>(those[lane])), got); });
    }
    if (pushes == 0) continue;
    if (is_damped) {
      for_each_lane<Pack>(pushes, [&](std::size_t lane) {
        Vec3d its_slip = slides ? view.slip_of(pair + lane) : Vec3d{};
        const ParticleContactForce pair_contact = force_of_pair(view, m, static_cast<std::size_t>(those[lane]), whose, its_slip);
        if (slides) view.set_slip(pair + lane, its_slip);
        force += pair_contact.normal + pair_contact.friction;
        got.energy += 0.5 * pair_contact.tangential_energy;
        got.friction_dissipation += 0.5 * pair_contact.friction_dissipation, got.damped_work += 0.5 * pair_contact.damped_work;
      });
      continue;
    }
    const Pack a = view.scale.distance_of(size, its_size), a_squared = a * a;
    const Pack spring =
        (mine * view.scale.weight_of(its_size, a) + its * view.scale.weight_of(size, a)) * (contact_weight_slope(squared / a_squared) / a_squared);  // S/r
    const Pack push = select(pushes, spring);
    sum -= push * between;
    if (!slides) continue;

    // as in force_of()
    const Pack inverse = inverse_square_root(squared);
    const Vec3<Pack> n = inverse * between;
    const auto [vx, vy, vz, its_volume] = gather_rows<Pack>(&view.motions->velocity.x, those);
    const Vec3<Pack> w{vx - Pack(speed.x), vy - Pack(speed.y), vz - Pack(speed.z)};
    const Vec3<Pack> across = slip - dot(slip, n) * n;
    const Pack length_squared = dot(slip, slip), across_squared = dot(across, across);
    const Pack turned = select(bits_where_greater(across_squared, Pack(0.0)), length_of(length_squared) * inverse_square_root(across_squared));
    const Vec3<Pack> before = turned * across, reached = before + Pack(view.dt) * (w - dot(n, w) * n);
    const Pack its_spring = whose == 0 ? spring_constant : gather<Pack>(spring_of, those);
    const Pack stiffness = Pack(tangential_share) * (Pack(0.5) * (spring_constant + its_spring)) * (volume * its_volume);
    const Pack reached_squared = dot(reached, reached), most = Pack(view.law.friction * view.face.oblique_share) * (spring * squared * inverse);
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
      for (std::size_t c = 0; c < 3; ++c) store(view.slip[c] + pair, after[c]);
      continue;
    }
    std::array<std::array<double, lanes<Pack>>, 3> slips;
    for (std::size_t c = 0; c < 3; ++c) store(slips[c].data(), after[c]);
    for_each_lane<Pack>(pushes, [&](std::size_t lane) { view.set_slip(pair + lane, {slips[0][lane], slips[1][lane], slips[2][lane]}); });
  }
  if (!is_loaded) return;
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

/// Force on a member [N]; zero where `got` has no contacts. The pressures of all members must be known.
template <class Pack>
FCCDA_HD Vec3d add_pairs_of(const ShortRangeView& view, std::size_t m, PairSum& got) {
  Vec3d force{};
  const std::size_t count = view.near_count[m];
  if (count == 0) {
    view.may_slip[m] = 0;
    return force;
  }
  got.energy = view.energy[m];
  got.compaction = view.compaction[m];
  // in the order of body and slot, those of the member's own body are contiguous
  const std::int32_t* near = view.near + view.first_near[m];
  const std::uint32_t body = view.body[m];
  const auto before = [&](std::size_t member) {
    return static_cast<std::size_t>(std::lower_bound(near, near + count, static_cast<std::int32_t>(member)) - near);
  };
  const std::size_t begin = view.has_several_bodies ? before(view.first_member[body]) : 0;
  const std::size_t end = view.has_several_bodies ? before(view.first_member[body + 1]) : count;
  constexpr std::size_t own = 0, others = 1;
  add_pairs<Pack>(view, m, 0, begin, others, force, got);
  add_pairs<Pack>(view, m, begin, end, own, force, got);
  add_pairs<Pack>(view, m, end, count, others, force, got);
  view.may_slip[m] = got.contacts > 0;
  return force;
}

}  // namespace perimpact
