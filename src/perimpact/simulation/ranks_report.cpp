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
  for (std::size_t rank = 0; rank < seconds.size(); ++rank) {
    double slots = 0;
    const auto slots_of = [&](const Share& share, const CellBox& part) {
      return static_cast<double>(part.cells()) * (share.is_of_lattice() ? 1 : fccda::byte_lanes);
    };
    for (const Body& body : simulation.bodies()) slots += slots_of(body.particles.share(), body.particles.share().part_of(static_cast<int>(rank)));
    for (std::size_t b = 0; b < loads.size(); ++b) {
      const Share& share = simulation.bodies()[b].particles.share();
      const CellBox part = share.part_of(static_cast<int>(rank));
      if (part.cells() > 0) loads[b].push_back({part, seconds[rank] / slots * slots_of(share, part) / static_cast<double>(part.cells())});
    }
  }
  return loads;
}

}  // namespace perimpact
