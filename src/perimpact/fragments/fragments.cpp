#include "perimpact/fragments/fragments.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "base/contract.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

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

/// Calls visit(i, j) for each intact bond once or twice; bonds of the stencil from the smaller slot only, but those to ghosts from their owned end.
template <class Visit>
void for_each_intact_bond(const Family& family, const Particles& particles, const Visit& visit) {
  const std::span<const std::ptrdiff_t> offsets = family.offsets();
  const bool is_whole = particles.share().is_whole();
  for (std::size_t eight = 0; eight < particles.slots() / byte_lanes; ++eight) {
    const std::uint8_t* bytes = family.bytes(eight);
    const std::size_t first = family.begin(eight), rows = family.begin(eight + 1) - first;
    for (std::size_t r = 0; r < rows; ++r) {
      if (family.stencil() && is_whole && offsets[r] < 0) continue;
      fccda::for_each_bit(bytes[r], [&](std::size_t lane) {
        const std::size_t i = eight * byte_lanes + lane;
        if (family.stencil())
          visit(i, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + offsets[r]));
        else
          visit(i, static_cast<std::size_t>(family.list()->neighbour[(first + r) * byte_lanes + lane]));
      });
    }
  }
}

/// The smallest slot on the whole lattice of the fragment of each owned particle, from the sets of slots of this rank. Fragments that ranks share are united
/// where one rank's particle is the ghost of another.
std::vector<std::uint64_t> names_of(const Particles& particles, Sets& sets) {
  const Share& share = particles.share();
  std::vector<std::uint64_t> names;  // of slots: within the rank, by the smallest slot of the set, which is also the smallest on the whole lattice
  const auto slots = particles.slot_of();
  if (share.is_whole()) {
    for (const std::uint32_t slot : slots) names.push_back(sets.root(slot));
    return names;
  }
  std::vector<std::uint64_t> of_slots(particles.slots());
  for (std::size_t slot = 0; slot < of_slots.size(); ++slot) of_slots[slot] = share.whole_slot(sets.root(static_cast<std::uint32_t>(slot)));
  std::vector<std::uint64_t> of_owners = of_slots;
  share.refresh({of_owners.data()});
  std::vector<std::uint8_t> has_owned(particles.slots(), 0);  // by the root of a set
  for (const std::uint32_t slot : slots) has_owned[sets.root(slot)] = 1;
  std::vector<std::array<std::uint64_t, 2>> same;
  share.for_each_ghost([&](std::size_t ghost) {
    const bool is_bonded = has_owned[sets.root(static_cast<std::uint32_t>(ghost))] != 0;
    if (is_bonded && of_slots[ghost] != of_owners[ghost]) same.push_back({of_slots[ghost], of_owners[ghost]});
  });
  std::ranges::sort(same);
  same.erase(std::unique(same.begin(), same.end()), same.end());
  std::unordered_map<std::uint64_t, std::uint64_t> parents;
  const auto root = [&](std::uint64_t name) {
    for (auto found = parents.find(name); found != parents.end(); found = parents.find(name)) name = found->second;
    return name;
  };
  for (const auto& [one, other] : share.ranks().join_all(std::span<const std::array<std::uint64_t, 2>>(same))) {
    const std::uint64_t a = root(one), b = root(other);
    if (a != b) parents[std::max(a, b)] = std::min(a, b);
  }
  for (const std::uint32_t slot : slots) names.push_back(root(of_slots[slot]));
  return names;
}

}  // namespace

Fragments::Fragments(const Particles& particles, const Family& family) : of_particles_(particles.size()) {
  Sets sets(particles.slots());
  for_each_intact_bond(family, particles, [&](std::size_t i, std::size_t j) { sets.unite(i, j); });
  const std::vector<std::uint64_t> names = names_of(particles, sets);

  // the particles of each name on all ranks, by name: fragments are numbered by their first particle, then by mass
  struct Counted {
    std::uint64_t name;
    std::uint64_t particles;
  };
  std::unordered_map<std::uint64_t, std::uint64_t> own;
  for (const std::uint64_t name : names) ++own[name];
  std::vector<Counted> counts;
  for (const auto& [name, count] : own) counts.push_back({name, count});
  counts = particles.share().ranks().join_all(std::span<const Counted>(counts));
  std::ranges::sort(counts, {}, &Counted::name);
  std::unordered_map<std::uint64_t, std::int32_t> number;
  for (const Counted& counted : counts) {
    if (number.emplace(counted.name, static_cast<std::int32_t>(fragments_.size())).second)
      fragments_.push_back({.particles = 0, .mass = 0, .first_slot = static_cast<std::size_t>(counted.name)});
    fragments_.back().particles += counted.particles;
  }
  for (std::size_t p = 0; p < names.size(); ++p) of_particles_[p] = number.at(names[p]);
  if (particles.lattice()) {
    for (Fragment& fragment : fragments_) fragment.mass = static_cast<double>(fragment.particles) * particles.material_mass(0);  // as Particles::total_mass()
  } else {
    std::vector<fccda::ExactSums<double>> sums(fragments_.size());
    for (std::size_t p = 0; p < names.size(); ++p) sums[static_cast<std::size_t>(of_particles_[p])].add(particles.volume(particles.slot_of()[p]));
    const std::vector<double> volumes = values_of_all(particles.share().ranks(), std::span(sums));
    for (std::size_t n = 0; n < fragments_.size(); ++n) fragments_[n].mass = particles.material_density() * volumes[n];
  }
  sort_by_mass();
}

void Fragments::sort_by_mass() {
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
  struct Means {
    Vec3d centre, velocity;
  };
  std::vector<fccda::ExactSums<Means>> means(count);
  std::vector<double> most(6 * count, -infinite);  // of the coordinates, and of the negative ones
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t slot = particles.slot_of()[p], n = static_cast<std::size_t>(fragments.of_particles()[p]);
    if (n >= count) continue;
    const Vec3d x = particles.position.at(slot);
    const double share = particles.material_mass(slot) / fragments.all()[n].mass, half = 0.5 * particles.size_of(slot);
    means[n].add({share * x, share * particles.velocity.at(slot)});
    for (std::size_t c = 0; c < 3; ++c) {
      const double reach = c == 2 && particles.is_plane() ? 0.5 * *particles.thickness() : half;
      most[6 * n + c] = std::max(most[6 * n + c], x[c] + reach);
      most[6 * n + 3 + c] = std::max(most[6 * n + 3 + c], reach - x[c]);
    }
  }
  Ranks& ranks = particles.share().ranks();
  ranks.max(most);
  const std::vector<Means> of_all = values_of_all(ranks, std::span(means));
  for (std::size_t n = 0; n < count; ++n) {
    states[n].centre = of_all[n].centre, states[n].velocity = of_all[n].velocity;
    for (std::size_t c = 0; c < 3; ++c) states[n].extent[c] = most[6 * n + c] + most[6 * n + 3 + c];
  }
  return states;
}

}  // namespace perimpact
