/// run.json: what was run, with what, how it went and where the time went.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "io/output/json.hpp"
#include "io/results/results_writer.hpp"
#include "mesh/surface.hpp"

namespace perimpact {

/// `wall_seconds` of the run, or of what came since it was resumed last; `resumed_at`: steps.
output::Json run_report(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds, std::span<const std::int64_t> resumed_at);

/// What construction of a surface found and mended.
output::Json surface_report(const fccda::SurfaceReport& report);

/// "closed" or "open"
std::string_view word_for(fccda::Closure closure);

}  // namespace perimpact
