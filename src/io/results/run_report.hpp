/// run.json: the setup, outcome and timers of a run.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "io/output/json.hpp"
#include "io/results/results_writer.hpp"
#include "mesh/surface.hpp"

namespace perimpact {

/// `wall_seconds`: wall-clock time of the run, or since the last restart; `resumed_at`: steps of the restarts.
output::Json run_report(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds, std::span<const std::int64_t> resumed_at);

/// Its members "bodies" and "impactors", by name.
output::Json bodies_report(const Simulation& simulation);
output::Json impactors_report(const Simulation& simulation);

/// Defects that the construction of a surface found and repaired.
output::Json surface_report(const fccda::SurfaceReport& report);

/// "closed" or "open"
std::string_view word_for(fccda::Closure closure);

}  // namespace perimpact
