/// Starter decks of src/cli/starters, embedded by the build (starters.cpp.in).
#pragma once

#include <span>
#include <string_view>

namespace perimpact {

struct Starter {
  std::string_view name;  ///< plate
  std::string_view text;  ///< of the deck
};

std::span<const Starter> starters();

}  // namespace perimpact
