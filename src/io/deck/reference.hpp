/// List of all deck keys, from the tables and schema that also read the deck.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace perimpact::deck {

/// Placeholder in paths for a name chosen by the user: bodies.<name>.spacing.
inline constexpr std::string_view any_name = "<name>";

/// Parent of the top-level keys.
inline constexpr std::string_view top_level = "the deck";

struct Entry {
  std::string path;   ///< bodies.<name>.material.poissons_ratio
  std::string form;   ///< "number [Pa]", "three numbers [m]", "one of x, y, z", "map"
  std::string range;  ///< "above 0"; empty for any number and for other types
  std::string need;   ///< "required", "optional", "default 3.015"
  bool is_map = false;
  std::string condition;  ///< "with model: ordinary-state", if only one alternative has it
  std::string sentence;

  std::string_view key() const;     ///< last part of the path
  std::string_view parent() const;  ///< the path without it, or top_level
};

/// In the order of the deck, each map before its contents.
const std::vector<Entry>& reference();

}  // namespace perimpact::deck
