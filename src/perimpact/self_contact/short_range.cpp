#include "perimpact/self_contact/short_range.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/particles/sum_over_eights.hpp"
#include "perimpact/self_contact/short_range_kernels.hpp"

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

/// Begins to load the first two cache lines of an array that is read soon.
template <class T>
void prefetch_lines(const T* array, std::size_t count) {
  constexpr std::size_t line = 64 / sizeof(T);
  if (count > 0) __builtin_prefetch(array);
  if (count > line) __builtin_prefetch(array + line);
}

/// Makes room for `count` more values, and for an eighth more: doubling the array, as it grows, would determine the peak memory of a run with rubble.
void reserve_more(auto& values, std::size_t count) {
  if (const std::size_t needed = values.size() + count; values.capacity() < needed) values.reserve(needed + needed / 8);
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
    mass_density_.push_back(body.particles.density());
    kept_.thresholds.emplace_back(body.particles.slots(), face_.density);
  }
  if (std::ranges::any_of(yield_pressure_, [](double pressure) { return std::isfinite(pressure); }))
    for (const ContactingBody& body : bodies) kept_.latest_pressures.emplace_back(body.particles.slots(), 0.0);
}

void ShortRange::forget() {
  keep_state();
  near_pairs_.forget();
}

void ShortRange::make_list(std::span<const ContactingBody> bodies) {
  keep_state();
  near_pairs_.make(bodies);
  derive_constants();
  restore_state();
}

ShortRangeView ShortRange::view(double dt) {
  return {law_,
          face_,
          {law_.distance_ratio, is_plane_},
          stiffness_.size() > 1,
          yields(),
          dt,
          near_pairs_.view(),
          body_.data(),
          first_member_.data(),
          mass_density_.data(),
          places_.data(),
          motions_.data(),
          {spring_[0].data(), spring_[1].data()},
          {density_stiffness_[0].data(), density_stiffness_[1].data()},
          {pressure_[0].data(), pressure_[1].data()},
          largest_overlap_.data(),
          threshold_.data(),
          yields() ? latest_pressure_.data() : nullptr,
          energy_of_.data(),
          compaction_of_.data(),
          near_count_.data(),
          may_slip_.data(),
          first_near_.data(),
          near_room_.data(),
          near_.data(),
          law_.friction > 0 ? std::array{slip_[0].data(), slip_[1].data(), slip_[2].data()} : std::array<double*, 3>{},
          is_near_.data()};
}

void ShortRange::add_forces(std::span<const ContactingBody> bodies, double dt) {
  if (near_pairs_.needs_new_list(bodies)) make_list(bodies);
  insert_broken_pairs(bodies);
  near_pairs_.refresh_foreign(bodies);
  if (is_scalar_)
    evaluate<double>(bodies, dt);
  else
    evaluate<NativePack>(bodies, dt);
  // members that are not in contact add zeros, so that the sums do not depend on the list; foreign ones do too
  const auto eight_of = [&](std::size_t m) { return eight_[m]; };
  enter(exact_sum_over_eights(near_pairs_.ranks(), eight_.size(), eight_of, [&](std::size_t m) { return may_be_loaded_[m] ? pair_sums_[m] : PairSum{}; }));
}

void ShortRange::insert_broken_pairs(std::span<const ContactingBody> bodies) {
  const std::vector<std::uint32_t> list = near_pairs_.members_with_broken_bonds();
  const auto members = near_pairs_.members();
  std::vector<std::uint8_t> lacks_room(list.size(), 1);
  const auto insert = [&] {
    const ShortRangeView view = this->view(0);
    fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(list.size()), [&](std::ptrdiff_t number) {
      const auto place = static_cast<std::size_t>(number);
      if (lacks_room[place] == 0) return;
      const std::size_t m = list[place], slot = members[m].slot;
      const std::uint8_t* bits = bodies[members[m].body].family.bytes(slot / byte_lanes);
      lacks_room[place] = !perimpact::insert_broken_pairs(view, m, [&](std::size_t row) { return ((bits[row] >> (slot % byte_lanes)) & 1u) != 0; });
    });
  };
  insert();
  if (std::ranges::find(lacks_room, 1) == lacks_room.end()) return;
  std::vector<std::size_t> lacking;
  for (std::size_t place = 0; place < list.size(); ++place)
    if (lacks_room[place] != 0) lacking.push_back(list[place]);
  give_room(lacking);
  insert();
}

/// Moves the pairs of some members that are in range to the end of their arrays, where there is room for all of their pairs.
void ShortRange::give_room(std::span<const std::size_t> lacking) {
  const PairsView pairs = near_pairs_.view();
  std::size_t to = near_.size() - byte_lanes, added = 0;
  for (const std::size_t m : lacking) added += fccda::in_eights(pairs.counts[m]);
  const auto extend = [&](auto& values) {
    reserve_more(values, added);
    values.resize(values.size() + added);
  };
  extend(near_);  // the next evaluation writes them
  if (law_.friction > 0) std::ranges::for_each(slip_, extend);
  for (const std::size_t m : lacking) {
    if (law_.friction > 0)
      for (fccda::AlignedVector<double>& component : slip_) std::copy_n(component.data() + first_near_[m], near_count_[m], component.data() + to);
    const std::size_t room = fccda::in_eights(pairs.counts[m]);
    first_near_[m] = to, near_room_[m] = static_cast<std::uint32_t>(room);
    to += room;
  }
}

void ShortRange::enter(const PairSum& sum) {
  energy_ = sum.energy;
  in_contact_now_ = static_cast<std::size_t>(sum.contacts) / 2;
  work_[0] += sum.friction_dissipation, work_[1] += sum.damped_work, work_[2] += sum.compaction;
}

template <class Pack>
void ShortRange::evaluate(std::span<const ContactingBody> bodies, double dt) {
  const ShortRangeView view = this->view(dt);
  const auto members = near_pairs_.members();
  const bool has_foreign = near_pairs_.ranks().size() > 1;
  fccda::parallel_for(static_cast<std::ptrdiff_t>(members.size()), [&](std::ptrdiff_t member) {
    const auto m = static_cast<std::size_t>(member);
    if (has_foreign && members[m].is_foreign) {
      const NearPairs::ForeignState& state = near_pairs_.foreign_state(members[m]);
      places_[m].position = state.position, motions_[m].velocity = state.velocity;
    } else {
      const Particles& particles = bodies[body_[m]].particles;
      places_[m].position = particles.position.at(slot_[m]), motions_[m].velocity = particles.velocity.at(slot_[m]);
    }
  });
  // Of very uneven cost, since most members have no pair without a bond, and foreign ones have none at all. What a member reads lies apart from that of the
  // member before, so that the processor does not foresee it.
  constexpr std::size_t block = 32, ahead = 6;
  const auto for_each_member = [&](const auto& prefetch, const auto& f) {
    fccda::parallel_for_blocks(members.size(), block, [&](std::size_t first, std::size_t last) {
      for (std::size_t m = first; m < last; ++m) {
        if (m + ahead < members.size()) prefetch(m + ahead);
        f(m);
      }
    });
  };
  const auto prefetch_others = [&](std::size_t m) { prefetch_lines(view.pairs.others + view.pairs.first_pair[m], view.pairs.unbonded_counts[m]); };
  // Few members are under pressure, which is never negative, or near one that is: near pairs are those of both members. Foreign members have no pairs here, so
  // that all are evaluated.
  std::ranges::fill(may_be_loaded_, static_cast<std::uint8_t>(has_foreign));
  for_each_member(prefetch_others, [&](std::size_t m) {
    evaluate_density<Pack>(view, m);
    if (has_foreign || (pressure_[0][m] == 0 && pressure_[1][m] == 0)) return;
    const auto mark = [&](std::size_t member) { std::atomic_ref(may_be_loaded_[member]).store(1, std::memory_order_relaxed); };
    mark(m);
    for (std::size_t n = 0; n < near_count_[m]; ++n) mark(static_cast<std::size_t>(near_[first_near_[m] + n]));
  });
  near_pairs_.refresh_members<std::array<double, 2>>(
      [&](std::size_t m) {
        return std::array{pressure_[0][m], pressure_[1][m]};
      },
      [&](std::size_t m, const std::array<double, 2>& pressures) {
        for (std::size_t whose = 0; whose < 2; ++whose) pressure_[whose][m] = pressures[whose];
      });
  const auto prefetch_slips = [&](std::size_t m) {
    if (view.slides())
      for (const double* component : view.slip) prefetch_lines(component + view.first_near[m], view.near_count[m]);
  };
  for_each_member(prefetch_slips, [&](std::size_t m) {
    if (view.pairs.unbonded_counts[m] == 0) return;  // its sum is zero since the list was built
    if (may_slip_[m]) may_be_loaded_[m] = 1;
    if (!may_be_loaded_[m]) return;
    PairSum sum;
    const Vec3d force = add_pairs_of<Pack>(view, m, sum);
    pair_sums_[m] = sum;
    if (sum.contacts == 0) return;
    VectorArray& density = bodies[body_[m]].particles.force_density;
    density.set(slot_[m], density.at(slot_[m]) + force / motions_[m].volume);
  });
}

/// Stores the state, before the list is rebuilt or the state is visited.
void ShortRange::keep_state() {
  if (is_kept_) return;
  is_kept_ = true;
  const auto members = near_pairs_.members();
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (members[m].is_foreign) continue;
    kept_.thresholds[members[m].body][members[m].slot] = threshold_[m];
    if (yields()) kept_.latest_pressures[members[m].body][members[m].slot] = latest_pressure_[m];
  }
  keep_pairs();
}

/// Gives the state to the members. Particles out of range have none.
void ShortRange::restore_state() {
  const auto restore = [&](std::vector<std::vector<double>>& of_bodies, double value, std::vector<double>& of_members) {
    const auto members = near_pairs_.members();
    for (std::size_t m = 0; m < members.size(); ++m) of_members[m] = members[m].is_foreign ? value : of_bodies[members[m].body][members[m].slot];
    for (std::vector<double>& of_body : of_bodies) std::ranges::fill(of_body, value);
  };
  restore(kept_.thresholds, face_.density, threshold_);
  if (yields()) restore(kept_.latest_pressures, 0, latest_pressure_);
  restore_pairs();
  is_kept_ = false;
}

void ShortRange::keep_pairs() {
  const auto members = near_pairs_.members();
  const auto is_stored = [&](std::size_t m, std::size_t n) { return members[static_cast<std::size_t>(near_pairs_.pairs_of(m).others[n])].id >= members[m].id; };
  std::size_t stored = 0;
  for (std::size_t m = 0; m < members.size(); ++m) for_each_near(m, [&](std::size_t n) { stored += is_stored(m, n); });
  make_room(kept_.ends, 2 * stored);
  if (law_.friction > 0) make_room(kept_.slips, 3 * stored);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(m);
    std::size_t next = first_near_[m];  // in range
    for_each_near(m, [&](std::size_t n) {
      const std::size_t pair = next++;
      if (!is_stored(m, n)) return;
      kept_.ends.push_back(members[m].id), kept_.ends.push_back(members[static_cast<std::size_t>(pairs.others[n])].id);
      if (law_.friction > 0)
        for (std::size_t c = 0; c < 3; ++c) kept_.slips.push_back(slip_[c][pair]);
    });
  }
}

/// After a restart, from a state of all ranks.
void ShortRange::discard_pairs_of_others() {
  if (near_pairs_.ranks().size() == 1) return;
  Kept all;
  std::swap(all.ends, kept_.ends), std::swap(all.slips, kept_.slips);
  for (std::size_t pair = 0; pair < all.pairs(); ++pair) {
    if (near_pairs_.owner_of(all.ends[2 * pair]) != near_pairs_.ranks().rank()) continue;
    kept_.ends.insert(kept_.ends.end(), {all.ends[2 * pair], all.ends[2 * pair + 1]});
    const Vec3d slip = all.slip(pair);
    if (!all.slips.empty()) kept_.slips.insert(kept_.slips.end(), {slip.x, slip.y, slip.z});
  }
}

/// What the kernels need of the members and pairs of a new list, apart from the state.
void ShortRange::derive_constants() {
  const auto members = near_pairs_.members();
  body_.assign(members.size(), 0);
  slot_.assign(members.size(), 0);
  eight_.assign(members.size(), 0);
  places_.assign(members.size(), {});
  motions_.assign(members.size(), {});
  for (auto* numbers : {&pressure_[0], &pressure_[1], &spring_[0], &spring_[1], &density_stiffness_[0], &density_stiffness_[1]})
    numbers->assign(members.size(), 0);
  for (auto* numbers : {&largest_overlap_, &threshold_, &energy_of_, &compaction_of_}) numbers->assign(members.size(), 0);
  if (yields()) latest_pressure_.assign(members.size(), 0);
  first_member_.assign(stiffness_.size() + 1, members.size());
  for (std::size_t m = members.size(); m-- > 0;) {
    const NearPairs::Member& i = members[m];
    body_[m] = i.body, slot_[m] = i.slot, eight_[m] = i.id / byte_lanes;
    places_[m].size = i.size, motions_[m].volume = i.volume;
    for (std::size_t whose = 0; whose < 2; ++whose)
      spring_[whose][m] = stiffness_[i.body][whose],
      density_stiffness_[whose][m] = density_stiffness(face_, stiffness_[i.body][whose], i.volume, law_.distance_ratio * i.size);
    largest_overlap_[m] = density_pressure(face_, yield_pressure_[i.body], i.volume, i.size, law_.distance_ratio * i.size) / density_stiffness_[0][m];
    first_member_[i.body] = m;
  }
  for (std::size_t b = stiffness_.size(); b-- > 0;) first_member_[b] = std::min(first_member_[b], first_member_[b + 1]);  // of a body without members
  pair_sums_.assign(members.size(), {});
  may_be_loaded_.assign(members.size(), 0);
  near_count_.assign(members.size(), 0);
  may_slip_.assign(members.size(), law_.friction > 0);
  is_near_.assign(near_pairs_.pair_count() / byte_lanes, 0);
  // Most pairs are bonded, and remain so until the next list. Room for all of them would keep what the passes read far apart.
  constexpr std::size_t spare = 8;
  const PairsView pairs = near_pairs_.view();
  first_near_.assign(members.size(), 0);
  near_room_.assign(members.size(), 0);
  std::size_t count = 0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const std::size_t all = pairs.counts[m], room = fccda::in_eights(reserves_all_pairs_ ? all : std::min<std::size_t>(pairs.unbonded_counts[m] + spare, all));
    first_near_[m] = count, near_room_[m] = static_cast<std::uint32_t>(room);
    count += room;
  }
  count += byte_lanes;  // packs of eight are read
  resize_to(near_, count);
  std::fill(near_.begin(), near_.end(), 0);
  if (law_.friction > 0)
    for (fccda::AlignedVector<double>& component : slip_) {
      resize_to(component, count);
      std::fill(component.begin(), component.end(), 0.0);
    }
}

/// Assigns the stored pairs to those of a new list.
void ShortRange::restore_pairs() {
  const ShortRangeView view = this->view(0);
  const auto restore = [&](std::uint64_t from, std::uint64_t to, const Vec3d& slip) {
    const auto m = near_pairs_.member_of_id(from), other = near_pairs_.member_of_id(to);
    if (!m || !other) return;
    const NearPairs::Pairs pairs = near_pairs_.pairs_of(*m);
    const std::int32_t* end = pairs.others + pairs.count;
    const std::int32_t* found = std::lower_bound(pairs.others, end, static_cast<std::int32_t>(*other));
    if (found == end || *found != static_cast<std::int32_t>(*other)) return;
    const auto number = static_cast<std::size_t>(found - pairs.others), pair = near_pairs_.first_pair(*m) + number;
    is_near_[pair / byte_lanes] |= static_cast<std::uint8_t>(1u << pair % byte_lanes);
    if (view.slides()) view.set_slip(first_near_[*m] + number, slip);
  };
  ListsByRank<SentPair> sent;
  for (std::size_t pair = 0; pair < kept_.pairs(); ++pair) {
    const std::array<std::uint64_t, 2> ends = {kept_.ends[2 * pair], kept_.ends[2 * pair + 1]};
    restore(ends[0], ends[1], kept_.slip(pair)), restore(ends[1], ends[0], -kept_.slip(pair));
    if (const int owner = near_pairs_.owner_of(ends[1]); owner != near_pairs_.ranks().rank()) sent[owner].push_back({ends, kept_.slip(pair)});
  }
  for (const auto& [from, pairs] : exchange_lists(near_pairs_.ranks(), sent))
    for (const SentPair& pair : pairs) restore(pair.ends[1], pair.ends[0], -pair.slip);
  // slips lie in the places of their pairs among those without a bond, and move to those of the pairs in range
  fccda::parallel_for(static_cast<std::ptrdiff_t>(near_count_.size()), [&](std::ptrdiff_t member) {
    const auto m = static_cast<std::size_t>(member);
    const std::size_t first = first_near_[m];
    for_each_near(m, [&](std::size_t number) {
      const std::size_t to = first + near_count_[m]++;
      if (view.slides()) view.set_slip(to, view.slip_of(first + number));
    });
  });
  kept_.ends.clear(), kept_.slips.clear();
}

/// Calls f(number) for the pairs of a member in range.
template <class F>
void ShortRange::for_each_near(std::size_t m, const F& f) const {
  const std::uint8_t* bits = is_near_.data() + near_pairs_.first_pair(m) / byte_lanes;
  for (std::size_t first = 0; first < near_pairs_.pairs_of(m).count; first += byte_lanes)
    for_each_bit(bits[first / byte_lanes], [&](std::size_t lane) { f(first + lane); });
}

std::vector<ShortRange::Bound> ShortRange::bounds(std::span<const ContactingBody> bodies) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<double> extremes;  // of each body: largest volume and mass, and minus the smallest
  for (const ContactingBody& body : bodies) {
    std::array<double, 4> of_body = {-far, -far, -far, -far};
    for (const std::uint32_t slot : body.particles.slot_of()) {
      const double volume = body.particles.volume(slot), mass = body.particles.mass(slot);
      of_body = {std::max(of_body[0], volume), std::max(of_body[1], mass), std::max(of_body[2], -volume), std::max(of_body[3], -mass)};
    }
    extremes.insert(extremes.end(), of_body.begin(), of_body.end());
  }
  near_pairs_.ranks().max(extremes);
  std::vector<Bound> bounds(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t other = 0; other < bodies.size(); ++other) {
      const double largest = extremes[4 * other], largest_mass = extremes[4 * other + 1], smallest = -extremes[4 * b + 2], smallest_mass = -extremes[4 * b + 3];
      const double k = in_series(bodies[b].stiffness, bodies[other].stiffness);
      const double mass = smallest_mass * largest_mass / (smallest_mass + largest_mass);  // a dashpot brakes the smallest particle most
      bounds[b].stiffness = std::max(bounds[b].stiffness, most_in_contact * k * largest);
      bounds[b].damping = std::max(bounds[b].damping, most_in_contact * 2 * law_.damping_ratio * std::sqrt(k * largest * mass / smallest));
    }
  return bounds;
}

}  // namespace perimpact
