/// The resolved Setup as text, for run.json.
#pragma once

#include <string>

#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// JSON, indented by two. It is also a valid deck (JSON is YAML) that reads back to a bitwise identical Setup. Absent values and those
/// that `published: true` sets are left out.
std::string setup_to_text(const Setup& setup);

}  // namespace perimpact::deck
