#include "io/deck/difference.hpp"

#include <algorithm>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

using MayDiffer = std::function<bool(std::string_view)>;

bool same(const YamlNode& a, const YamlNode& b) {
  return a.kind == b.kind && a.text == b.text && std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same) &&
         std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                    [](const auto& x, const auto& y) { return x.key == y.key && same(x.value, y.value); });
}

std::string value_in_words(const YamlNode* node) {
  if (!node) return "";
  if (node->kind != YamlNode::Kind::list) return node->in_words();
  std::string text;
  for (const YamlNode& item : node->items) {
    constexpr std::size_t longest = 60;  // of a list that is shown in full
    text += (text.empty() ? "[" : ", ") + item.in_words();
    if (text.size() > longest) return text + ", …]";
  }
  return (text.empty() ? "[" : text) + "]";
}

bool is_map(const YamlNode* node) { return node && node->kind == YamlNode::Kind::map; }

/// Difference of two values, one of which may be missing.
std::optional<Difference> difference_of(const YamlNode* before, const YamlNode* now, const std::string& key, const MayDiffer& may_differ);

std::optional<Difference> difference_of_maps(const YamlNode& before, const YamlNode& now, const std::string& key, const MayDiffer& may_differ) {
  const std::string prefix = key.empty() ? "" : key + ".";
  for (const YamlNode::Entry& entry : now.entries) {
    const YamlNode::Entry* same_key = before.find(entry.key);
    if (auto found = difference_of(same_key ? &same_key->value : nullptr, &entry.value, prefix + entry.key, may_differ)) return found;
  }
  for (const YamlNode::Entry& entry : before.entries)
    if (!now.find(entry.key))
      if (auto found = difference_of(&entry.value, nullptr, prefix + entry.key, may_differ)) return found;
  return std::nullopt;
}

std::optional<Difference> difference_of(const YamlNode* before, const YamlNode* now, const std::string& key, const MayDiffer& may_differ) {
  if (may_differ(key)) return std::nullopt;
  if (is_map(before) && is_map(now)) return difference_of_maps(*before, *now, key, may_differ);
  if (before && now && same(*before, *now)) return std::nullopt;
  return Difference{key, value_in_words(before), value_in_words(now)};
}

}  // namespace

std::optional<Difference> first_difference(std::string_view before, std::string_view now, const MayDiffer& may_differ) {
  return difference_of_maps(parse_document(before, "the deck before"), parse_document(now, "the deck now"), "", may_differ);
}

}  // namespace perimpact::deck
