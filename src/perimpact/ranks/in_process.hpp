/// Ranks that are threads of one process: for tests and sanitizers, without MPI.
#pragma once

#include <functional>

#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// Calls run(ranks) in `size` threads at once, as that many ranks. If a call throws, the others fail in their next collective call; the first exception is
/// thrown again here.
void run_in_process(int size, const std::function<void(Ranks&)>& run);

}  // namespace perimpact
