/// run.json: what was run, with what, how it went and where the time went.
#pragma once

#include <string>

#include "fccda/surface/surface.hpp"
#include "io/output/json.hpp"
#include "io/results/results_writer.hpp"

namespace perimpact {

output::Json run_report(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds);

/// What construction of a surface found and mended.
output::Json surface_report(const fccda::SurfaceReport& report);

/// "closed", "open" or "non-manifold"
std::string_view word_for(fccda::Closure closure);

}  // namespace perimpact
