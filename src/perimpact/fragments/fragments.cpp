#include "perimpact/fragments/fragments.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "base/contract.hpp"

namespace perimpact {

namespace {

using fccda::byte_lanes;

/// Disjoint sets of slots (union-find). The root is the smallest slot, so that the result is independent of the order of unions.
class Sets {
 public:
  explicit Sets(std::size_t slots) : parent_(slots) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t slot) {
    while (parent_[slot] != slot) slot = parent_[slot] = parent_[parent_[slot]];  // path halving
    return slot;
  }

  void unite(std::size_t i, std::size_t j) {
    const std::uint32_t a = root(static_cast<std::uint32_t>(i)), b = root(static_cast<std::uint32_t>(j));
    if (a < b)
      parent_[b] = a;
    else
      parent_[a] = b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Calls visit(i, j) for each intact bond once or twice; bonds of the stencil from the smaller slot only.
template <class Visit>
void for_each_intact_bond(const Family& family, std::size_t slots, const Visit& visit) {
  const std::span<const std::ptrdiff_t> offsets = family.offsets();
  for (std::size_t eight = 0; eight < slots / byte_lanes; ++eight) {
    const std::uint8_t* bytes = family.bytes(eight);
    const std::size_t first = family.begin(eight), rows = family.begin(eight + 1) - first;
    for (std::size_t r = 0; r < rows; ++r) {
      if (family.stencil() && offsets[r] < 0) continue;
      fccda::for_each_bit(bytes[r], [&](std::size_t lane) {
        const std::size_t i = eight * byte_lanes + lane;
        if (family.stencil())
          visit(i, i + static_cast<std::size_t>(offsets[r]));
        else
          visit(i, static_cast<std::size_t>(family.list()->neighbour[(first + r) * byte_lanes + lane]));
      });
    }
  }
}

}  // namespace

Fragments::Fragments(const Particles& particles, const Family& family) : of_particles_(particles.size()) {
  Sets sets(particles.slots());
  for_each_intact_bond(family, particles.slots(), [&](std::size_t i, std::size_t j) { sets.unite(i, j); });

  // numbered by their first particle, then by mass
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> number(particles.slots(), none);  // of each root
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::uint32_t slot = particles.slot_of()[p], root = sets.root(slot);
    if (number[root] == none) {
      number[root] = static_cast<std::int32_t>(fragments_.size());
      fragments_.push_back({.particles = 0, .mass = 0, .first_slot = slot});
    }
    Fragment& fragment = fragments_[static_cast<std::size_t>(number[root])];
    ++fragment.particles;
    fragment.mass += particles.volume(slot);  // equal counts of equal particles give equal sums
    of_particles_[p] = number[root];
  }
  for (Fragment& fragment : fragments_) fragment.mass *= particles.density();

  std::vector<std::int32_t> order(fragments_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto mass = [&](std::int32_t n) { return fragments_[static_cast<std::size_t>(n)].mass; };
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return mass(a) > mass(b); });
  std::vector<Fragment> sorted;
  std::vector<std::int32_t> rank(order.size());
  for (const std::int32_t old : order) {
    rank[static_cast<std::size_t>(old)] = static_cast<std::int32_t>(sorted.size());
    sorted.push_back(fragments_[static_cast<std::size_t>(old)]);
  }
  fragments_ = std::move(sorted);
  for (std::int32_t& fragment : of_particles_) fragment = rank[static_cast<std::size_t>(fragment)];
}

FragmentCount Fragments::count() const {
  FragmentCount count;
  double mass = 0;
  for (const Fragment& fragment : fragments_) mass += fragment.mass;
  for (const Fragment& fragment : fragments_) {
    ++(fragment.particles > 1 ? count.fragments : count.single_particles);
    if (fragment.mass > 0.01 * mass) ++count.above_one_percent;
  }
  if (!fragments_.empty()) count.largest = fragments_[0].mass;
  if (fragments_.size() > 1) count.second_largest = fragments_[1].mass;
  for (std::size_t n = 1; n < fragments_.size(); ++n) count.outside_largest += fragments_[n].mass;
  return count;
}

std::vector<FragmentState> states_of(const Fragments& fragments, const Particles& particles, std::size_t count) {
  EXPECTS(count <= fragments.all().size() && fragments.of_particles().size() == particles.size());
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<FragmentState> states(count);
  std::vector<Vec3d> low(count, Vec3d{infinite, infinite, infinite}), high(count, Vec3d{-infinite, -infinite, -infinite});
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t slot = particles.slot_of()[p], n = static_cast<std::size_t>(fragments.of_particles()[p]);
    if (n >= count) continue;
    const Vec3d x = particles.position.at(slot);
    const double share = particles.mass(slot) / fragments.all()[n].mass, half = 0.5 * particles.size_of(slot);
    states[n].centre += share * x;
    states[n].velocity += share * particles.velocity.at(slot);
    for (std::size_t c = 0; c < 3; ++c) {
      const double reach = c == 2 && particles.is_plane() ? 0.5 * *particles.thickness() : half;
      low[n][c] = std::min(low[n][c], x[c] - reach);
      high[n][c] = std::max(high[n][c], x[c] + reach);
    }
  }
  for (std::size_t n = 0; n < count; ++n) states[n].extent = high[n] - low[n];
  return states;
}

}  // namespace perimpact
