/// Every key that a deck may have, from the same tables and schema that read it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace perimpact::deck {

/// Stands in paths where the user chooses a name: bodies.<name>.spacing.
inline constexpr std::string_view any_name = "<name>";

/// Parent of the keys of the first level.
inline constexpr std::string_view top_level = "the deck";

struct Entry {
  std::string path;   ///< bodies.<name>.material.poissons_ratio
  std::string form;   ///< "number [Pa]", "three numbers [m]", "one of x, y, z", "map"
  std::string range;  ///< "above 0"; empty for any number and for what is no number
  std::string need;   ///< "required", "optional", "default 3.015"
  bool is_map = false;
  std::string condition;  ///< "with model: ordinary-state", where it is known to one alternative only
  std::string sentence;

  std::string_view key() const;     ///< last part of the path
  std::string_view parent() const;  ///< the path without it, or top_level
};

/// In the order of the deck, each map before what is in it.
const std::vector<Entry>& reference();

}  // namespace perimpact::deck
