#include "perimpact/self_contact/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr std::size_t block = 256;  // particles per task of a thread

/// Skin in mean spacings of the finest body. Measured (benchmarks/fragments): where a quarter or all of a plate disperses at a hundredth of the speed of
/// sound, 0.35 and 0.75 cost 3 to 7 and 9 to 38 % more: a thin skin needs more rebuilds, a thick one has more pairs.
constexpr double skin_ratio = 0.5;

// marks of a cell
constexpr std::uint8_t holds_lost = 1;      // contains a particle that has lost a bond
constexpr std::uint8_t holds_exposed = 2;   // contains an exposed particle
constexpr std::uint8_t is_near_damage = 4;  // itself or a neighbour contains one that has lost a bond
constexpr std::uint8_t is_near = 8;         // itself or a neighbour contains one that searches for contacts

/// Calls f(first, last) for blocks of [0, count).
template <class F>
void for_each_block(std::size_t count, const F& f) {
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>((count + block - 1) / block), [&](std::ptrdiff_t b) {
    const std::size_t first = static_cast<std::size_t>(b) * block;
    f(first, std::min(first + block, count));
  });
}

}  // namespace

NearPairs::NearPairs(const ShortRangeLaw& law, std::span<const ContactingBody> bodies) : law_(law) {
  double finest = far, largest = 0;
  std::size_t count = 0;
  for (const ContactingBody& body : bodies) count += body.particles.size();
  particles_.reserve(count);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Particles& particles = bodies[b].particles;
    finest = std::min(finest, particles.spacing());
    exposures_.emplace_back(particles, bodies[b].family, bodies[b].broken_ends);
    std::vector<std::uint32_t>& at = particle_at_.emplace_back(particles.slots(), 0);
    for (const std::uint32_t slot : particles.slot_of()) {
      at[slot] = static_cast<std::uint32_t>(particles_.size());
      particles_.push_back({static_cast<std::uint32_t>(b), slot, particles.reference(slot), particles.size_of(slot), particles.volume(slot),
                            static_cast<std::uint32_t>(particles_.size())});
      largest = std::max(largest, particles_.back().size);
    }
  }
  skin_ = skin_ratio * finest;
  longest_ = weight_reach * law.distance_ratio * largest;
  reference_positions_ = VectorArray(particles_.size(), 0);
  near_damage_.assign(particles_.size(), 0);
  first_pair_.assign(1, 0);
}

bool NearPairs::needs_new_list(std::span<const ContactingBody> bodies) {
  bool is_valid = is_known_;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const std::uint32_t slot : exposures_[b].update(bodies[b].family, bodies[b].broken_ends)) is_valid = is_valid && near_damage_[particle_at_[b][slot]];
  return !is_valid || has_moved_by_skin(bodies);
}

bool NearPairs::has_moved_by_skin(std::span<const ContactingBody> bodies) {
  struct Moved {
    Vec3d low{far, far, far}, high{-far, -far, -far};
    double furthest = 0;  // [m²] from the drift
  };
  std::vector<Moved> of_block((particles_.size() + block - 1) / block);
  for_each_block(particles_.size(), [&](std::size_t first, std::size_t last) {
    Moved moved;
    for (std::size_t p = first; p < last; ++p) {
      const Vec3d by = bodies[particles_[p].body].particles.position.at(particles_[p].slot) - reference_positions_.at(p);
      for (std::size_t c = 0; c < 3; ++c) moved.low[c] = std::min(moved.low[c], by[c]), moved.high[c] = std::max(moved.high[c], by[c]);
      moved.furthest = std::max(moved.furthest, squared_norm(by - drift_));
    }
    of_block[first / block] = moved;
  });
  Moved all;
  for (const Moved& moved : of_block) {
    for (std::size_t c = 0; c < 3; ++c) all.low[c] = std::min(all.low[c], moved.low[c]), all.high[c] = std::max(all.high[c], moved.high[c]);
    all.furthest = std::max(all.furthest, moved.furthest);
  }
  const double diagonal = squared_norm(all.high - all.low);
  drift_ = 0.5 * (all.low + all.high);  // the next step's
  return !(diagonal <= skin_ * skin_ || all.furthest <= 0.25 * skin_ * skin_);
}

void NearPairs::make(std::span<const ContactingBody> bodies) {
  ++times_made_;
  is_known_ = true;
  for_each_block(particles_.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) reference_positions_.set(p, bodies[particles_[p].body].particles.position.at(particles_[p].slot));
  });
  drift_ = {};
  cells_.sort(reference_positions_, longest_ + skin_);
  mark_cells();

  struct Part {
    std::vector<Found> found;
    std::array<std::uint32_t, block> counts{};
  };
  std::vector<Part> parts((particles_.size() + block - 1) / block);
  for_each_block(particles_.size(), [&](std::size_t first, std::size_t last) {
    Part& part = parts[first / block];
    std::vector<Found> found;
    for (std::size_t p = first; p < last; ++p) {
      near_damage_[p] = (cell_marks_[cells_.cell_of(p)] & is_near_damage) != 0;
      if (!(cell_marks_[cells_.cell_of(p)] & is_near)) continue;
      find_of(p, bodies, found);
      part.counts[p - first] = static_cast<std::uint32_t>(found.size());
      part.found.insert(part.found.end(), found.begin(), found.end());
    }
  });

  members_.clear();
  first_pair_.assign(1, 0);
  pair_counts_.clear();
  broken_ends_.clear();
  std::vector<std::uint32_t> member_of(particles_.size());
  std::vector<std::size_t> first_of_part;
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    if (p % block == 0) first_of_part.push_back(members_.size());
    const std::uint32_t count = parts[p / block].counts[p % block];
    if (count == 0) continue;
    member_of[p] = static_cast<std::uint32_t>(members_.size());
    members_.push_back(particles_[p]);
    pair_counts_.push_back(count);
    broken_ends_.push_back(bodies[particles_[p].body].broken_ends[particles_[p].slot / fccda::byte_lanes]);
    first_pair_.push_back(first_pair_.back() + (count + fccda::byte_lanes - 1) / fccda::byte_lanes * fccda::byte_lanes);
  }
  resize_to(others_, first_pair_.back());
  resize_to(bonds_, first_pair_.back());
  unbonded_counts_.assign(members_.size(), 0);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(parts.size()), [&](std::ptrdiff_t part) {
    const std::vector<Found>& found = parts[static_cast<std::size_t>(part)].found;
    std::size_t next = 0;
    for (std::size_t m = first_of_part[static_cast<std::size_t>(part)]; next < found.size(); ++m) {
      std::size_t pair = first_pair_[m];
      const std::size_t last = next + pair_counts_[m];
      const auto add = [&](bool bonded) {
        for (std::size_t n = next; n < last; ++n) {
          if ((found[n].bond != no_bond) != bonded) continue;
          others_[pair] = static_cast<std::int32_t>(member_of[found[n].particle]);
          bonds_[pair++] = found[n].bond;
        }
      };
      add(false);
      unbonded_counts_[m] = static_cast<std::uint32_t>(pair - first_pair_[m]);
      add(true);
      next = last;
      for (; pair < first_pair_[m + 1]; ++pair) others_[pair] = 0, bonds_[pair] = no_bond;  // padding, read but not used
    }
  });
}

void NearPairs::mark_cells() {
  cell_marks_.assign(cells_.size(), 0);
  const auto for_each_cell = [&](const auto& f) {
    for_each_block(cells_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t cell = first; cell < last; ++cell) f(cell);
    });
  };
  for_each_cell([&](std::size_t cell) {
    std::uint8_t mark = 0;
    for (const std::uint32_t p : cells_.points_in(cell)) {
      const Exposure& exposure = exposures_[particles_[p].body];
      if (exposure.has_lost(particles_[p].slot)) mark |= holds_lost;
      if (exposure.is_exposed(particles_[p].slot)) mark |= holds_exposed;
    }
    cell_marks_[cell] = mark;
  });
  // marks of the neighbours are combined in a second array, so that no thread reads what another writes
  const auto widen = [&](unsigned from, std::uint8_t to) {
    std::vector<std::uint8_t> widened(cell_marks_.size());
    for_each_cell([&](std::size_t cell) {
      unsigned around = 0;
      cells_.for_each_around(cell, [&](std::size_t other) { around |= cell_marks_[other]; });
      widened[cell] = static_cast<std::uint8_t>(cell_marks_[cell] | ((around & from) ? to : 0));
    });
    cell_marks_ = std::move(widened);
  };
  widen(holds_lost, is_near_damage);
  widen(holds_exposed | is_near_damage, is_near);
}

void NearPairs::find_of(std::size_t p, std::span<const ContactingBody> bodies, std::vector<Found>& found) const {
  found.clear();
  const Member& i = particles_[p];
  const Exposure& exposure = exposures_[i.body];
  const bool near_damage = (cell_marks_[cells_.cell_of(p)] & is_near_damage) != 0, searches = near_damage || exposure.is_exposed(i.slot);
  const double horizon = bodies[i.body].family.horizon(), surely_bonded = (1 - 1e-9) * horizon * horizon, reach = longest_ + skin_;
  bool may_be_bonded = false;
  cells_.for_each_around(cells_.cell_of(p), [&](std::size_t cell) {
    const bool others_near_damage = (cell_marks_[cell] & is_near_damage) != 0;
    if (!searches && !others_near_damage && !(cell_marks_[cell] & holds_exposed)) return;
    cells_.for_each_within(cell, reference_positions_.at(p), reach * reach, [&](std::uint32_t q) {
      if (q == p) return;
      const Member& j = particles_[q];
      if (!searches && !others_near_damage && !exposures_[j.body].is_exposed(j.slot)) return;
      const bool one_body = i.body == j.body;
      // between two particles that have lost no bond, a bond of theirs is intact
      if (one_body && !near_damage && !others_near_damage && squared_norm(j.reference - i.reference) < surely_bonded) return;
      const double least = reach_of(i, j) + skin_;
      if (!(squared_norm(reference_positions_.at(q) - reference_positions_.at(p)) < least * least)) return;
      may_be_bonded = may_be_bonded || one_body;
      found.push_back({q, no_bond});
    });
  });
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.particle < b.particle; });
  if (may_be_bonded) name_bonds(p, bodies, found);
}

void NearPairs::name_bonds(std::size_t p, std::span<const ContactingBody> bodies, std::span<Found> found) const {
  const Member& i = particles_[p];
  const Family& family = bodies[i.body].family;
  const std::size_t eight = i.slot / fccda::byte_lanes;
  std::size_t next = 0;  // both are sorted by slot
  family.for_each_bond(i.slot, [&](const FamilyBond& bond) {
    const std::uint32_t particle = particle_at_[i.body][bond.j];
    while (next < found.size() && found[next].particle < particle) ++next;
    if (next == found.size() || found[next].particle != particle) return;
    const std::size_t row = family.stencil() ? bond.index : bond.index / fccda::byte_lanes - family.begin(eight);
    found[next].bond = static_cast<std::uint32_t>(row);
  });
}

}  // namespace perimpact
