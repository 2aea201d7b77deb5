#include "perimpact/particles/cloud_part.hpp"

#include <numeric>

namespace perimpact {

CloudPartition::CloudPartition(std::size_t eights, int ranks, int first_rank, std::span<const MeasuredPart> load) : ranks_(ranks), first_rank_(first_rank) {
  const std::size_t parts = std::min(eights, static_cast<std::size_t>(ranks));
  if (load.empty()) {
    for (std::size_t part = 0; part <= parts; ++part) cuts_.push_back(eights * part / parts);
    return;
  }
  const std::vector<double> costs = costs_of_layers(load, {{0, 0, 0}, {static_cast<int>(eights), 1, 1}}, 0);
  const double whole = std::accumulate(costs.begin(), costs.end(), 0.0);
  cuts_.push_back(0);
  double below = 0;
  std::size_t next = 0;
  for (std::size_t part = 1; part < parts; ++part) {
    const double wanted = whole * static_cast<double>(part) / static_cast<double>(parts);
    const std::size_t last = eights - (parts - part);  // one eight at least for each part that follows
    while (next <= cuts_.back() || (next < last && below + 0.5 * costs[next] < wanted)) below += costs[next++];
    cuts_.push_back(next);
  }
  cuts_.push_back(eights);
}

}  // namespace perimpact
