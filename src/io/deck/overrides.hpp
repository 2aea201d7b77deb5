/// Overrides of deck values from the command line: --set time.step="0.1 us".
#pragma once

#include <string>
#include <string_view>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

/// Sets the value, in YAML, at the path "key.key" of the tree; missing maps along the path are created. `place`: origin of the value in
/// messages. Throws InputError if the path leads into a value that is not a map.
void set_value(YamlNode& tree, const std::string& path, std::string_view text, const std::string& place);
void set_value(YamlNode& tree, const std::string& path, YamlNode value, const std::string& place);

/// Applies "key.path=value" to the tree. Whether the key is known is checked when the whole deck is read, with the place "--set key.path".
/// Throws InputError for another form, and if the path leads into a value that is not a map.
void apply_override(YamlNode& deck, const std::string& override_text);

}  // namespace perimpact::deck
