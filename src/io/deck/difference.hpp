/// First difference between two resolved decks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace perimpact::deck {

struct Difference {
  std::string key;          ///< bodies.plate.spacing
  std::string before, now;  ///< "0.005", "[0, -32, 0]"; empty: the key is absent
};

/// The first key of `now` whose value differs, else the first that only `before` has; both are texts of setup_to_text. Keys with
/// `may_differ(key)` are ignored.
std::optional<Difference> first_difference(std::string_view before, std::string_view now, const std::function<bool(std::string_view)>& may_differ);

}  // namespace perimpact::deck
