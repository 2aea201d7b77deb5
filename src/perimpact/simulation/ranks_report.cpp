#include "perimpact/simulation/ranks_report.hpp"

#include <algorithm>
#include <span>

namespace perimpact {

RanksReport report_of_ranks(const Simulation& simulation) {
  struct OfRank {
    Traffic sent;
    double forces;
  };
  const OfRank own{simulation.traffic_of_steps(), simulation.seconds_of_forces()};
  const std::vector<OfRank> ranks = simulation.ranks().join_all(std::span(&own, 1));
  RanksReport report{};
  for (const OfRank& rank : ranks) {
    report.all += rank.sent;
    report.most_bytes = std::max(report.most_bytes, rank.sent.bytes);
    report.mean_forces += rank.forces;
    report.largest_forces = std::max(report.largest_forces, rank.forces);
  }
  report.all.seconds /= static_cast<double>(ranks.size());
  report.mean_forces /= static_cast<double>(ranks.size());
  return report;
}

std::vector<MeasuredLoad> measured_loads(const Simulation& simulation) {
  constexpr double least = 0.1;  // [s] of a rank in the phases of force
  Ranks& ranks = simulation.ranks();
  std::vector<MeasuredLoad> loads(simulation.bodies().size());
  const double own = simulation.seconds_of_forces();
  const std::vector<double> seconds = ranks.join_all(std::span(&own, 1));
  if (ranks.size() == 1 || std::ranges::max(seconds) < least) return loads;
  const auto share_of = [&](std::size_t body) -> const Share& { return simulation.bodies()[body].particles.share(); };
  const auto slots_of_cell = [&](std::size_t body) { return share_of(body).is_of_lattice() ? 1.0 : static_cast<double>(fccda::byte_lanes); };
  for (int rank = 0; rank < ranks.size(); ++rank) {
    double slots = 0;
    for (std::size_t b = 0; b < loads.size(); ++b) slots += static_cast<double>(share_of(b).part_of(rank).cells()) * slots_of_cell(b);
    for (std::size_t b = 0; b < loads.size(); ++b)
      if (const CellBox part = share_of(b).part_of(rank); part.cells() > 0)
        loads[b].push_back({part, seconds[static_cast<std::size_t>(rank)] / slots * slots_of_cell(b)});
  }
  return loads;
}

}  // namespace perimpact
