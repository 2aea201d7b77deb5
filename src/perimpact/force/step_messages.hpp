/// What a rank sends in a step, known before the step.
#pragma once

#include <cstddef>
#include <vector>

#include "perimpact/ranks/traffic.hpp"

namespace perimpact {

/// In a step in which nothing fails, flows or is in contact, whose sums over particles are not sampled for the history.
struct StepMessages {
  std::vector<std::size_t> refreshed;  ///< [byte] sent of each cell, in each exchange of ghosts (Share::refresh)
  Traffic collectives;                 ///< reductions and collections

  StepMessages& operator+=(const StepMessages& other) {
    refreshed.insert(refreshed.end(), other.refreshed.begin(), other.refreshed.end());
    collectives += other.collectives;
    return *this;
  }
};

}  // namespace perimpact
