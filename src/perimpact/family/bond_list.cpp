#include "perimpact/family/bond_list.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "perimpact/family/slot_tree.hpp"
#include "perimpact/family/stencil.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

constexpr double rounding = 1e-12;  // [-] more than that of squares and roots

/// The bonds of a point cloud, found particle by particle.
class BondSearch {
 public:
  BondSearch(FamilyRule rule, double horizon, const Particles& particles)
      : rule_(rule), horizon_(horizon), particles_(particles), tree_(particles), size_(particles.slots()) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(size_.size()), [&](std::ptrdiff_t slot) {
      size_[static_cast<std::size_t>(slot)] = particles.size_of(static_cast<std::size_t>(slot));  // a cube root: once for each particle, not for each bond
    });
    for (std::size_t slot = 0; slot < size_.size(); ++slot)
      if (particles.is_occupied(slot)) least_size_ = std::min(least_size_, size_[slot]), largest_size_ = std::max(largest_size_, size_[slot]);
  }

  /// [m] reference distances to the neighbours, squared, in ascending order of their slots
  struct Found {
    std::vector<std::int32_t> slots;
    std::vector<double> squared;
  };
  void find(std::size_t slot, Found& found) const {
    found.slots.clear(), found.squared.clear();
    for_each_neighbour(slot, [&](std::size_t eight, const auto& squared, unsigned bits) {
      fccda::for_each_bit(bits, [&](std::size_t lane) {
        found.slots.push_back(static_cast<std::int32_t>(eight * byte_lanes + lane));
        found.squared.push_back(squared[lane]);
      });
    });
  }

  std::size_t count(std::size_t slot) const {
    std::size_t sum = 0;
    for_each_neighbour(slot, [&](std::size_t, const auto&, unsigned bits) { sum += static_cast<std::size_t>(std::popcount(bits)); });
    return sum;
  }

  /// [m³] v V_j
  double volume(std::size_t i, std::size_t j, double length) const {
    const double mean = mean_size(size_[i], size_[j]);
    return std::min(1.0, (horizon_ + 0.5 * mean - length) / mean) * particles_.volume(j);
  }

 private:
  static double mean_size(double one, double other) { return 0.5 * (one + other); }
  bool are_bonded(std::size_t i, std::size_t j, double squared) const {
    const double length = std::sqrt(squared);
    const double longest = reach(size_[i], size_[j]);
    return rule_ == FamilyRule::hu_ha_bobaru ? length < longest : length <= longest;
  }
  /// [m] bonds of a particle of this size to those of another end here
  double reach(double size, double of_other) const { return horizon_ + reach_beyond_horizon(rule_) * mean_size(size, of_other); }

  /// Calls visit(eight, squared, bits) for each eight slots with neighbours, in ascending order.
  template <class Visit>
  void for_each_neighbour(std::size_t slot, const Visit& visit) const {
    const double least = reach(size_[slot], least_size_) * (1 - rounding), certain = least * least;
    tree_.visit_near(particles_.reference(slot), reach(size_[slot], largest_size_) * (1 + rounding),
                     [&](std::size_t eight, const auto& squared, unsigned bits) {
                       if (eight == slot / byte_lanes) bits &= ~(1u << (slot % byte_lanes));
                       unsigned doubtful = 0;
                       for (std::size_t lane = 0; lane < byte_lanes; ++lane) doubtful |= static_cast<unsigned>(squared[lane] >= certain) << lane;
                       fccda::for_each_bit(bits & doubtful, [&](std::size_t lane) {
                         if (!are_bonded(slot, eight * byte_lanes + lane, squared[lane])) bits &= ~(1u << lane);
                       });
                       if (bits != 0) visit(eight, squared, bits);
                     });
  }

  FamilyRule rule_;
  double horizon_;
  const Particles& particles_;
  SlotTree tree_;
  std::vector<double> size_;  // [m] of each slot
  double least_size_ = std::numeric_limits<double>::infinity(), largest_size_ = 0;
};

}  // namespace

BondList find_bonds(FamilyRule rule, double horizon, const Particles& particles) {
  const BondSearch search(rule, horizon, particles);
  const std::size_t eights = particles.slots() / byte_lanes;
  const auto for_each_eight = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(eights), [&](std::ptrdiff_t eight) { f(static_cast<std::size_t>(eight)); });
  };

  BondList list{.horizon = horizon, .beyond_horizon = reach_beyond_horizon(rule)};
  list.begin.assign(eights + 1, 0);
  for_each_eight([&](std::size_t eight) {
    for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; ++slot)
      if (particles.owns(slot)) list.begin[eight + 1] = std::max(list.begin[eight + 1], search.count(slot));
  });
  for (std::size_t eight = 0; eight < eights; ++eight) list.begin[eight + 1] += list.begin[eight];

  const std::size_t rows = list.begin.back(), entries = rows * byte_lanes;
  list.bits.assign(rows, 0);
  list.neighbour.resize(entries);
  list.length.resize(entries);
  list.volume.resize(entries);
  for_each_eight([&](std::size_t eight) {
    const std::size_t begin = list.begin[eight], of_eight = list.begin[eight + 1] - begin;
    BondSearch::Found found;
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      const std::size_t slot = eight * byte_lanes + lane;
      found.slots.clear();
      if (particles.owns(slot)) search.find(slot, found);
      for (std::size_t r = 0; r < found.slots.size(); ++r) {
        const std::size_t row = begin + r, entry = row * byte_lanes + lane;
        const double length = std::sqrt(found.squared[r]);
        list.bits[row] = static_cast<std::uint8_t>(list.bits[row] | (1u << lane));
        list.neighbour[entry] = found.slots[r];
        list.length[entry] = length;
        list.volume[entry] = search.volume(slot, static_cast<std::size_t>(found.slots[r]), length);
      }
      for (std::size_t r = found.slots.size(); r < of_eight; ++r) {
        const std::size_t entry = (begin + r) * byte_lanes + lane;
        list.neighbour[entry] = static_cast<std::int32_t>(slot), list.length[entry] = 1, list.volume[entry] = 0;
      }
    }
  });
  return list;
}

}  // namespace perimpact
