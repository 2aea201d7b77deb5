/// The memory of a run, as `perimpact check` prints it.
#pragma once

#include <string>

#include "io/output/json.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

std::string memory_text(const Memory& memory);
output::Json memory_json(const Memory& memory);

}  // namespace perimpact
