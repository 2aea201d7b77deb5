/// What the ranks of a run have sent and computed.
#pragma once

#include <vector>

#include "perimpact/particles/measured_load.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// Of the steps of this program so far, without set-up and output.
struct RanksReport {
  Traffic all;                         ///< sums over the ranks; seconds their mean
  std::int64_t most_bytes;             ///< that a rank has sent in messages
  double mean_forces, largest_forces;  ///< [s] of a rank in the phases of force, without waiting for others

  double imbalance() const { return mean_forces > 0 ? largest_forces / mean_forces : 1; }  ///< [-] of the time in the phases of force
};

/// Requires ranks that count what they send. Collective.
RanksReport report_of_ranks(const Simulation& simulation);

/// Of each body, from the time of each rank in the phases of force, which its cells of all bodies share equally; nothing for a run of one rank, or before
/// the clock resolves the ranks. On all ranks. Collective.
std::vector<MeasuredLoad> measured_loads(const Simulation& simulation);

}  // namespace perimpact
