#include "perimpact/particles/sum_over_eights.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"

using namespace perimpact;

namespace {

struct MassAndEnergy {
  double mass, energy;
  MassAndEnergy& operator+=(const MassAndEnergy& other) {
    mass += other.mass, energy += other.energy;
    return *this;
  }
  bool operator==(const MassAndEnergy&) const = default;
};

/// A ball filled with a lattice: its rows begin and end amid eights.
Particles ball() {
  const Lattice lattice{.cells = {37, 31, 29}, .spacing = 0.1};
  Particles particles(lattice, 1, 917, [](const Vec3d& x) { return norm(x - Vec3d{1.8, 1.5, 1.4}) < 1.37; });
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> speed(0, 6);
  for (const std::uint32_t slot : particles.slot_of()) particles.velocity.set(slot, {speed(random), -speed(random), speed(random)});
  return particles;
}

/// The slots with their eights in random order.
std::vector<std::uint32_t> permuted(std::span<const std::uint32_t> slots, std::mt19937_64& random) {
  std::vector<std::uint32_t> eights;
  for (const std::uint32_t slot : slots)
    if (eights.empty() || eights.back() != slot / 8) eights.push_back(slot / 8);
  std::shuffle(eights.begin(), eights.end(), random);
  std::vector<std::uint32_t> all;
  for (const std::uint32_t eight : eights) {
    const auto begin = std::lower_bound(slots.begin(), slots.end(), 8 * eight), end = std::lower_bound(slots.begin(), slots.end(), 8 * (eight + 1));
    all.insert(all.end(), begin, end);
  }
  return all;
}

}  // namespace

TEST_CASE("sums over eights: they are exact sums of the plain sums of eights") {
  const Particles particles = ball();
  const auto energy = [&](std::size_t slot) { return particles.mass(slot) * squared_norm(particles.velocity.at(slot)); };
  fccda::ExactSum exact;
  for (std::size_t eight = 0; eight < particles.slots() / 8; ++eight) {
    double of_eight = 0;
    for (std::size_t slot = 8 * eight; slot < 8 * eight + 8; ++slot)
      if (particles.is_occupied(slot)) of_eight += energy(slot);
    exact.add(of_eight);
  }
  CHECK(exact_sum_over_eights(particles, energy) == exact.value());
}

TEST_CASE("sums over eights: the order of the eights and the number of threads do not matter") {
  const Particles particles = ball();
  REQUIRE(particles.size() > 5000);  // many shares of work
  std::mt19937_64 random(2);
  const auto sum_of = [&](std::span<const std::uint32_t> slots) {
    return exact_sum_over_eights(alone(), slots, [&](std::size_t k) {
      return MassAndEnergy{particles.mass(slots[k]), particles.mass(slots[k]) * squared_norm(particles.velocity.at(slots[k]))};
    });
  };
  const auto plain = [&](std::span<const std::uint32_t> slots) {
    double sum = 0;
    for (const std::uint32_t slot : slots) sum += particles.mass(slot) * squared_norm(particles.velocity.at(slot));
    return sum;
  };
  const MassAndEnergy expected = sum_of(particles.slot_of());
  int plain_sums_that_differ = 0;
  for (const int threads : {1, 2, 3})
    for (int trial = 0; trial < 10; ++trial) {
      const fixtures::Threads with_several(threads);
      const std::vector<std::uint32_t> slots = permuted(particles.slot_of(), random);
      REQUIRE(slots.size() == particles.size());
      plain_sums_that_differ += plain(slots) != plain(particles.slot_of());
      CHECK(sum_of(slots) == expected);
    }
  CHECK(plain_sums_that_differ > 20);
}

TEST_CASE("sums over eights: parts of a list of slots, cut between eights, add up to the whole") {
  const Particles particles = ball();
  const std::span<const std::uint32_t> slots = particles.slot_of();
  const auto energy = [&](std::size_t slot) { return particles.mass(slot) * squared_norm(particles.velocity.at(slot)); };
  std::array<fccda::ExactSum, 3> parts;  // of processes, each with its eights
  for (std::size_t begin = 0; begin < slots.size();) {
    std::size_t end = begin;
    while (end < slots.size() && slots[end] / 8 == slots[begin] / 8) ++end;
    const auto eight = slots.subspan(begin, end - begin);
    parts[slots[begin] / 8 % 3].add(exact_sum_over_eights(alone(), eight, [&](std::size_t k) { return energy(eight[k]); }));
    begin = end;
  }
  parts[0].add(parts[1]), parts[0].add(parts[2]);
  CHECK(parts[0].value() == exact_sum_over_eights(particles, energy));
}

TEST_CASE("sums over eights: each particle is visited once") {
  const Particles particles = ball();
  std::vector<int> visits(particles.slots(), 0);
  exact_sum_over_eights(particles, [&](std::size_t slot) {
    ++visits[slot];
    return 1.0;
  });
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) REQUIRE(visits[slot] == (particles.is_occupied(slot) ? 1 : 0));
  CHECK(exact_sum_over_eights(particles, [](std::size_t) { return 1.0; }) == static_cast<double>(particles.size()));
  CHECK(exact_sum_over_eights(alone(), std::span<const std::uint32_t>(), [](std::size_t) { return 1.0; }) == 0);
}
