/// YAML document as a tree with the position of every value. Only yaml_node.cpp depends on yaml-cpp.
///
/// Decks use a subset of YAML: maps with words as keys, lists, words. Unlike in yaml-cpp, a key must be unique in its map.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace perimpact::deck {

/// Begins the place of each value that `--set` gave.
inline constexpr std::string_view override_mark = "--set ";

struct YamlNode {
  enum class Kind { nothing, word, list, map };
  struct Entry;

  Kind kind = Kind::nothing;
  std::string place;            ///< file:line:column, both from 1, columns in characters
  std::string text;             ///< of a word
  std::vector<YamlNode> items;  ///< of a list
  std::vector<Entry> entries;   ///< of a map, in the order written

  Entry* find(std::string_view key);
  const Entry* find(std::string_view key) const;
  bool is_override() const { return place.starts_with(override_mark); }  ///< given by `--set`
  /// For messages: 0.6, "5 kg", a list, a map, nothing. Long text is cut.
  std::string in_words() const;
};

struct YamlNode::Entry {
  std::string key;
  std::string place;  ///< of the key
  YamlNode value;
};

/// Parses the map of a file. Throws InputError for invalid YAML, duplicate keys, an empty document, a document that is not a map, tabs in
/// the indentation, more than one document, tags, anchors and aliases.
YamlNode parse_document(std::string_view text, const std::string& file);

/// Parses one YAML value; all its nodes have the position `place`.
YamlNode parse_value(std::string_view text, const std::string& place);

/// Throws InputError with "place: sentence"; control characters become spaces, so that it stays on one line.
[[noreturn]] void refuse(std::string_view place, std::string_view sentence);

}  // namespace perimpact::deck
