#include "perimpact/family/cloud_parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <mutex>
#include <random>
#include <vector>

#include "base/pack.hpp"
#include "perimpact/discretisation/space_order.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

namespace {

/// Points at random in a slab, along the space-filling curve; the last eight is not full.
Cloud slab(std::size_t count) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> x(0, 4), y(0, 2), z(0, 0.5), volume(0.5, 1.5);
  std::vector<Vec3d> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back({x(random), y(random), z(random)});
  Cloud cloud{.points = {}, .volumes = {}, .thickness = {}, .numbers = {}};
  for (const std::uint32_t k : space_order(points))
    cloud.points.push_back(points[k]), cloud.volumes.push_back(1e-3 * volume(random)), cloud.numbers.push_back(k);
  return cloud;
}

}  // namespace

TEST_CASE("cloud part: every rank has the points within reach of its own, and after a refresh their values are those of their owners") {
  const Cloud cloud = slab(3003);
  constexpr double reach = 0.3;
  for (const int count : {2, 3, 7, 16}) {
    CAPTURE(count);
    std::vector<int> owners(cloud.points.size(), 0);
    std::mutex mutex;
    run_in_process(count, [&](Ranks& ranks) {
      const CloudPartition partition(fccda::eights_of(cloud.points.size()), count, 1);
      const Share share(ranks, CloudParts(cloud, reach, partition).of(ranks.rank()));
      const Particles particles(cloud, 1, share);
      std::vector<double> values(particles.slots(), -1);
      for (const std::uint32_t slot : particles.slot_of()) values[slot] = 7.0 * static_cast<double>(share.whole_slot(slot));
      share.refresh({values.data()});
      const std::lock_guard guard(mutex);
      for (const std::uint32_t slot : particles.slot_of()) ++owners[share.whole_slot(slot)];
      std::size_t missing = 0, wrong = 0, unnamed = 0;
      for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        const auto is_near = [&](std::uint32_t slot) { return squared_norm(particles.reference(slot) - cloud.points[k]) < reach * reach; };
        if (!std::ranges::any_of(particles.slot_of(), is_near)) continue;
        const auto local = share.local_slot(k);
        if (!local || !particles.is_occupied(*local)) {
          ++missing;
          continue;
        }
        const bool has_its_data = values[*local] == 7.0 * static_cast<double>(k) && particles.reference(*local) == cloud.points[k] &&
                                  particles.volume(*local) == cloud.volumes[k] && particles.numbers()[*local] == cloud.numbers[k];
        if (!has_its_data) ++wrong;
        if (share.owner_of(k) != ranks.rank() && share.owned_slot(k)) ++unnamed;
      }
      CHECK(missing == 0);
      CHECK(wrong == 0);
      CHECK(unnamed == 0);
      CHECK(particles.spacing() == spacing_of(cloud));
      // eights that read no ghosts: no point of another rank is within reach
      for (std::size_t eight = 0; eight < particles.slots() / 8; ++eight) {
        if (!particles.is_owned_eight(eight)) continue;
        bool reads = false;
        for (std::size_t slot = 8 * eight; slot < 8 * eight + 8 && particles.is_occupied(slot); ++slot)
          for (std::size_t k = 0; k < cloud.points.size(); ++k)
            reads = reads || (share.owner_of(k) != ranks.rank() && squared_norm(particles.reference(slot) - cloud.points[k]) < reach * reach);
        CHECK(share.reads_ghosts(eight) == reads);
      }
    });
    CHECK(std::ranges::all_of(owners, [](int ranks) { return ranks == 1; }));
  }
}

TEST_CASE("cloud part: numbers of eights are gathered in the order of the whole cloud, also where eights have unequal numbers, and each rank takes its own") {
  const Cloud cloud = slab(403);
  const std::size_t eights = fccda::eights_of(cloud.points.size());
  const auto rows_of = [](std::size_t eight) { return 1 + eight * 7 % 5; };
  std::vector<int> expected;
  for (std::size_t eight = 0; eight < eights; ++eight)
    for (std::size_t row = 0; row < rows_of(eight); ++row) expected.push_back(static_cast<int>(100 * eight + row));
  for (const int count : {2, 5, 60}) {  // 60: more ranks than eights, nine of which have none
    CAPTURE(count);
    std::mutex mutex;
    run_in_process(count, [&](Ranks& ranks) {
      const Share share(ranks, CloudParts(cloud, 0.2, CloudPartition(eights, count, 3 % count)).of(ranks.rank()));
      std::vector<std::size_t> begin{0};
      std::vector<int> own;
      for (std::size_t eight = 0; eight < share.eights().size(); ++eight) {
        const bool is_owned = share.owner_of(8 * std::size_t{share.eights()[eight]}) == ranks.rank();
        for (std::size_t row = 0; is_owned && row < rows_of(share.eights()[eight]); ++row) own.push_back(static_cast<int>(100 * share.eights()[eight] + row));
        begin.push_back(own.size());
      }
      const NumbersOfEights numbers{.begin = begin};
      const std::vector<int> gathered = share.gather(std::span<const int>(own), numbers);
      std::vector<int> taken(own.size(), -1);
      share.take(std::span<const int>(ranks.is_root() ? expected : std::vector<int>()), std::span<int>(taken), numbers);
      const std::size_t all = share.count_of_whole(numbers);
      const std::lock_guard guard(mutex);
      if (ranks.is_root()) CHECK(gathered == expected);
      CHECK(taken == own);
      CHECK(all == expected.size());
      CHECK(share.parts() == std::min<int>(count, static_cast<int>(eights)));
    });
  }
}
