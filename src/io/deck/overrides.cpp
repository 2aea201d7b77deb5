#include "io/deck/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/deck/key_path.hpp"

namespace perimpact::deck {

void set_value(YamlNode& tree, const std::string& path, std::string_view text, const std::string& place) {
  set_value(tree, path, parse_value(text, place), place);
}

void set_value(YamlNode& tree, const std::string& path, YamlNode value, const std::string& place) {
  YamlNode* node = &tree;
  std::string parent;
  for (const std::string_view key : keys_of(path)) {
    if (node->kind == YamlNode::Kind::nothing) node->kind = YamlNode::Kind::map;
    if (node->kind != YamlNode::Kind::map)
      refuse(place, fmt::format("{} is {}, not a map, and has no keys to set; set {} itself.", parent, node->in_words(), parent));
    YamlNode::Entry* entry = node->find(key);
    if (!entry)
      entry = &node->entries.emplace_back(YamlNode::Entry{.key = std::string(key), .place = place, .value = {.kind = YamlNode::Kind::nothing, .place = place}});
    node = &entry->value;
    (parent += parent.empty() ? "" : ".") += key;
    if (parent == path) entry->place = place;
  }
  *node = std::move(value);
}

void apply_override(YamlNode& deck, const std::string& override_text) {
  const std::size_t equals = override_text.find('=');
  const std::string path = override_text.substr(0, equals);
  const std::string place = std::string(override_mark) + path;
  const std::vector<std::string_view> keys = keys_of(path);
  const bool has_empty_part = std::find(keys.begin(), keys.end(), std::string_view()) != keys.end();
  if (equals == std::string::npos || has_empty_part) refuse("--set " + override_text, "expected key.path=value, for example --set output.frames=0.");

  set_value(deck, path, std::string_view(override_text).substr(equals + 1), place);
}

}  // namespace perimpact::deck
