/// The Setup as resolved, for run.json.
#pragma once

#include <string>

#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// JSON, indented by two. It is a deck too (JSON is YAML): read again it gives the same Setup, bit for bit. Values that are absent
/// or that `published: true` sets are left out.
std::string setup_to_text(const Setup& setup);

}  // namespace perimpact::deck
