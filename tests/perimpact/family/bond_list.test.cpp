#include "perimpact/family/bond_list.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"

using namespace perimpact;

namespace {

constexpr double h = 0.01;  // [m] mean distance of the points
using fccda::byte_lanes;

enum class Order { rows, random };

/// Points around those of a grid, with volumes from a tenth to ten times those of its cells. In random order the boxes of consecutive slots overlap.
Cloud cloud(int nx, int ny, int nz, Order order, unsigned seed = 3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-0.3, 0.3), decade(-1, 1);
  Cloud cloud;
  if (nz == 1) cloud.thickness = h;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        cloud.points.push_back(h * Vec3d{i + move(random), j + move(random), nz == 1 ? 0 : k + move(random)});
        cloud.volumes.push_back(h * h * h * std::pow(10, decade(random)));
      }
  if (order == Order::random) {
    std::vector<std::size_t> to(cloud.points.size());
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = k;
    std::shuffle(to.begin(), to.end(), random);
    Cloud mixed{.thickness = cloud.thickness};
    for (const std::size_t k : to) mixed.points.push_back(cloud.points[k]), mixed.volumes.push_back(cloud.volumes[k]);
    return mixed;
  }
  return cloud;
}

struct Bond {
  std::int32_t neighbour;
  double length, volume;
  bool operator==(const Bond&) const = default;
};

/// Of each slot, in the order of the list.
std::vector<std::vector<Bond>> bonds_in(const BondList& list, std::size_t slots) {
  std::vector<std::vector<Bond>> bonds(slots);
  for (std::size_t eight = 0; eight < slots / byte_lanes; ++eight)
    for (std::size_t row = list.begin[eight]; row < list.begin[eight + 1]; ++row)
      for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
        const std::size_t entry = row * byte_lanes + lane;
        if ((list.bits[row] >> lane) & 1u)
          bonds[eight * byte_lanes + lane].push_back({list.neighbour[entry], list.length[entry], list.volume[entry]});
        else
          REQUIRE(Bond{list.neighbour[entry], list.length[entry], list.volume[entry]} == Bond{static_cast<std::int32_t>(eight * byte_lanes + lane), 1, 0});
      }
  return bonds;
}

/// The definition, over all pairs.
std::vector<std::vector<Bond>> bonds_by_definition(FamilyRule rule, double horizon, const Particles& particles) {
  std::vector<std::vector<Bond>> bonds(particles.slots());
  for (const std::uint32_t i : particles.slot_of())
    for (const std::uint32_t j : particles.slot_of()) {
      const double length = norm(particles.reference(j) - particles.reference(i)), mean = 0.5 * (particles.size_of(i) + particles.size_of(j));
      const bool is_near = rule == FamilyRule::hu_ha_bobaru ? length < horizon + 0.5 * mean : length <= horizon;
      if (i != j && is_near)
        bonds[i].push_back({static_cast<std::int32_t>(j), length, std::min(1.0, (horizon + 0.5 * mean - length) / mean) * particles.volume(j)});
    }
  return bonds;
}

void check_bonds(const Particles& particles, double horizon) {
  for (const FamilyRule rule : {FamilyRule::hu_ha_bobaru, FamilyRule::madenci_oterkus}) {
    const BondList list = find_bonds(rule, horizon, particles);
    const auto found = bonds_in(list, particles.slots()), defined = bonds_by_definition(rule, horizon, particles);
    for (std::size_t slot = 0; slot < particles.slots(); ++slot) CHECK(found[slot] == defined[slot]);
    for (std::size_t eight = 0; eight < particles.slots() / byte_lanes; ++eight) {
      std::size_t longest = 0;
      for (std::size_t lane = 0; lane < byte_lanes; ++lane) longest = fixtures::larger(longest, defined[eight * byte_lanes + lane].size());
      CHECK(list.begin[eight + 1] - list.begin[eight] == longest);
    }
  }
}

}  // namespace

TEST_CASE("bond list: bonds, lengths and volumes are bitwise those of a search over all pairs, for particles of very different sizes in any order") {
  for (const Order order : {Order::rows, Order::random})
    for (const double ratio : {1.2, 3.015}) {
      check_bonds(Particles(cloud(11, 9, 8, order), 1000), ratio * h);
      check_bonds(Particles(cloud(21, 17, 1, order), 1000), ratio * h);
    }
}

TEST_CASE("bond list: particles far from all others, and those beside a removed one, have the bonds of a search over all pairs") {
  Cloud scattered = cloud(6, 6, 6, Order::rows);
  for (const double away : {1.0, -1e3, 1e6})
    for (const double beside : {0.0, 0.5}) scattered.points.push_back({away + beside * h, 0, 0}), scattered.volumes.push_back(h * h * h);
  Particles particles(scattered, 1000);
  const std::vector<std::size_t> removed{0, 7, 8, 9, 10, 11, 12, 13, 14, 15, 100};  // among them a pack of eight
  particles.remove(removed);
  check_bonds(particles, 3 * h);
}

TEST_CASE("bond list: neighbours at the distance of the horizon itself are bonded as their lengths in floating point say, as seen from both ends") {
  Cloud lattice;
  for (int k = 0; k < 7; ++k)
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 7; ++i) lattice.points.push_back({0.1 * i, 0.1 * j, 0.1 * k}), lattice.volumes.push_back(0.001);
  const Particles particles(lattice, 1000);
  for (const double horizon : {0.1 * 3, 0.3, 0.25, 0.1 * std::sqrt(5.0)}) check_bonds(particles, horizon);
}

TEST_CASE("bond list: one, two and seven threads find the same") {
  const Particles particles(cloud(23, 21, 19, Order::rows), 1000);
  std::map<int, BondList> lists;
  for (const int threads : {1, 2, 7}) {
    const fixtures::Threads with_several(threads);
    lists.emplace(threads, find_bonds(FamilyRule::hu_ha_bobaru, 3.015 * h, particles));
  }
  for (const int threads : {2, 7}) {
    const BondList &one = lists.at(1), &other = lists.at(threads);
    CHECK(one.begin == other.begin);
    CHECK(one.bits == other.bits);
    CHECK(one.neighbour == other.neighbour);
    CHECK(one.length == other.length);
    CHECK(one.volume == other.volume);
  }
}
