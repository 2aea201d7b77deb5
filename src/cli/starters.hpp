/// Decks to start from, as src/cli/starters holds them: the build puts their text into the program (starters.cpp.in).
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
