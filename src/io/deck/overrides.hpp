/// Changes to a deck from the command line: --set time.step="0.1 us".
#pragma once

#include <string>
#include <string_view>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

/// Puts the value, in YAML, at the path "key.key" of the tree, in place of what stands there; maps on the way are made where they are absent.
/// `place`: how messages call where it comes from. Throws InputError where the path leads into something that is no map.
void set_value(YamlNode& tree, const std::string& path, std::string_view text, const std::string& place);
void set_value(YamlNode& tree, const std::string& path, YamlNode value, const std::string& place);

/// Puts the value of "key.path=value" into the tree. Whether the path exists is checked with the whole deck when it is read: there the place is "--set
/// key.path". Throws InputError for another form, and where the path leads into something that is no map.
void apply_override(YamlNode& deck, const std::string& override_text);

}  // namespace perimpact::deck
