/// Deprecated keys and words of decks, renamed since 0.1.0. They are accepted until 0.2.0, each with a warning that states the new name.
#pragma once

#include <string>
#include <vector>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

/// Gives deprecated keys and words of a deck their current names, in place. Returns a warning for each: position, old name, new name.
/// Where a map has the old and the new name, the two are merged; a value that `--set` gave under either name wins. Throws InputError
/// where the deck itself gives one value under both names.
std::vector<std::string> rename_deprecated_keys(YamlNode& deck);

}  // namespace perimpact::deck
