/// The forecast of a run of several ranks, as `perimpact check --ranks` prints it.
#pragma once

#include <optional>
#include <string>

#include "io/output/json.hpp"
#include "perimpact/simulation/forecast.hpp"
#include "perimpact/simulation/memory.hpp"
#include "perimpact/simulation/rank_forecast.hpp"

namespace perimpact {

/// `memory`: of a run of one process. `step`: absent where steps are not forecast; messages are then omitted.
std::string ranks_text(const Setup& setup, const RankForecast& ranks, const Memory& memory, const std::optional<Forecast>& step, const Network& network);
output::Json ranks_json(const Setup& setup, const RankForecast& ranks, const Memory& memory, const std::optional<Forecast>& step, const Network& network);

}  // namespace perimpact
