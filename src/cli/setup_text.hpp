/// Summary of a simulation that is set up: bodies, impactors, first contacts, time step. As text, and as JSON for programs.
#pragma once

#include <string>

#include "io/output/json.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

std::string setup_text(const Simulation& simulation);

/// "bodies", "impactors" as in run.json, with first contacts; "time".
output::Json setup_json(const Simulation& simulation);

}  // namespace perimpact
