/// A YAML document as a tree in which every value knows where it was written. The only file that knows yaml-cpp is yaml_node.cpp.
///
/// Decks use a part of YAML: maps with words as keys, lists, words. Stricter than yaml-cpp, a key may stand only once in a map.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace perimpact::deck {

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
  /// How messages call it: 0.6, "5 kg", a list, a map, nothing. Long text is cut.
  std::string in_words() const;
};

struct YamlNode::Entry {
  std::string key;
  std::string place;  ///< of the key
  YamlNode value;
};

/// The map that a file holds. Throws InputError for what is not YAML, a key given twice, an empty document, a document that is
/// not a map, a tab in the indentation, more than one document, tags, anchors and aliases.
YamlNode parse_document(std::string_view text, const std::string& file);

/// One value in YAML, all of which is said to stand at `place`.
YamlNode parse_value(std::string_view text, const std::string& place);

/// Throws InputError with "place: sentence", on one line whatever the deck held.
[[noreturn]] void refuse(std::string_view place, std::string_view sentence);

}  // namespace perimpact::deck
