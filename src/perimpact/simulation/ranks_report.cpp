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

}  // namespace perimpact
