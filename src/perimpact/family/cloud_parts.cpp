#include "perimpact/family/cloud_parts.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace perimpact {

using fccda::byte_lanes;

double largest_reach(FamilyRule rule, double horizon_ratio, const Cloud& cloud) {
  constexpr double rounding = 1e-9;
  const double horizon = horizon_ratio * spacing_of(cloud), largest = size_of_volume(*std::ranges::max_element(cloud.volumes), cloud.thickness);
  return (horizon + (rule == FamilyRule::hu_ha_bobaru ? 0.5 * largest : 0)) * (1 + rounding);
}

CloudParts::CloudParts(const Cloud& cloud, double reach, CloudPartition partition)
    : cloud_(cloud), reach_(reach), partition_(std::move(partition)), tree_(cloud.points) {}

CloudPart CloudParts::of(int rank) const {
  CloudPart part{.partition = partition_, .eights = {}, .reads_ghosts = {}, .exchanged = {}};
  const int own = partition_.part_of(rank);
  if (own == partition_.parts()) {  // without a part: one eight, since no array is empty
    part.eights = {0};
    part.reads_ghosts = {0};
    return part;
  }
  const std::size_t first = partition_.begin(own), end = partition_.end(own);
  std::vector<std::vector<std::uint32_t>> near(end - first);  // eights of other ranks, of each owned eight
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(near.size()), [&](std::ptrdiff_t number) {
    std::vector<std::uint32_t>& eights = near[static_cast<std::size_t>(number)];
    const std::size_t begin = (first + static_cast<std::size_t>(number)) * byte_lanes;
    for (std::size_t slot = begin; slot < std::min(begin + byte_lanes, cloud_.points.size()); ++slot)
      tree_.visit_near(cloud_.points[slot], reach_, [&](std::size_t eight, const auto&, unsigned) {
        if (eight < first || eight >= end) eights.push_back(static_cast<std::uint32_t>(eight));
      });
    std::ranges::sort(eights);
    eights.erase(std::unique(eights.begin(), eights.end()), eights.end());
  });

  std::set<std::uint32_t> ghosts;
  for (const std::vector<std::uint32_t>& eights : near) ghosts.insert(eights.begin(), eights.end());
  const auto before = ghosts.lower_bound(static_cast<std::uint32_t>(first));
  part.eights.assign(ghosts.begin(), before);
  const std::size_t first_owned = part.eights.size();
  for (std::size_t eight = first; eight < end; ++eight) part.eights.push_back(static_cast<std::uint32_t>(eight));
  part.eights.insert(part.eights.end(), before, ghosts.end());
  part.reads_ghosts.assign(part.eights.size(), 0);

  // distances are the same from both ends, so that the ranks of both know what is sent
  std::map<int, std::set<std::uint32_t>> sent, received;
  for (std::size_t k = 0; k < near.size(); ++k) {
    part.reads_ghosts[first_owned + k] = near[k].empty() ? 0 : 1;
    for (const std::uint32_t ghost : near[k]) sent[partition_.owner_of(ghost)].insert(static_cast<std::uint32_t>(first_owned + k));
  }
  for (std::size_t place = 0; place < part.eights.size(); ++place)
    if (place < first_owned || place >= first_owned + near.size()) received[partition_.owner_of(part.eights[place])].insert(static_cast<std::uint32_t>(place));
  for (const auto& [other, places] : received)
    part.exchanged.push_back({other, {sent.at(other).begin(), sent.at(other).end()}, {places.begin(), places.end()}});
  return part;
}

}  // namespace perimpact
