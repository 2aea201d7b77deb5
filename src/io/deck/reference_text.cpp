#include "io/deck/reference_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/deck/key_path.hpp"
#include "io/deck/overrides.hpp"
#include "io/deck/reference.hpp"
#include "io/deck/reference_pages.hpp"

namespace perimpact::deck {

namespace {

const YamlNode* child(const YamlNode& map, std::string_view key) {
  const YamlNode::Entry* entry = map.find(key);
  return entry ? &entry->value : nullptr;
}

std::string word(const YamlNode& map, std::string_view key) {
  const YamlNode* node = child(map, key);
  return node ? node->text : "";
}

std::vector<std::string> words(const YamlNode* list) {
  std::vector<std::string> all;
  if (list && list->kind == YamlNode::Kind::word) all.push_back(list->text);
  if (list)
    for (const YamlNode& item : list->items) all.push_back(item.text);
  return all;
}

Example example_of(const YamlNode& node) {
  Example example{.caption = word(node, "caption"), .fragment = word(node, "deck"), .files = {}};
  if (const YamlNode* files = child(node, "files"))
    for (const YamlNode::Entry& file : files->entries) example.files.emplace_back(file.key, file.value.text);
  return example;
}

PageText parse_page(const PageSource& source) {
  const YamlNode tree = parse_document(source.text, std::string(source.name) + ".yaml");
  for (const YamlNode::Entry& entry : tree.entries) {
    constexpr std::string_view known[] = {"title", "text", "maps", "examples", "refused", "restrictions", "related"};
    if (std::find(std::begin(known), std::end(known), entry.key) == std::end(known)) refuse(entry.place, "a page has no such key.");
  }
  PageText page{.name = std::string(source.name),
                .title = word(tree, "title"),
                .text = word(tree, "text"),
                .maps = words(child(tree, "maps")),
                .examples = {},
                .refused = {},
                .restrictions = words(child(tree, "restrictions")),
                .related = words(child(tree, "related"))};
  if (const YamlNode* examples = child(tree, "examples"))
    for (const YamlNode& each : examples->items) page.examples.push_back(example_of(each));
  if (const YamlNode* refused = child(tree, "refused"))
    for (const YamlNode& each : refused->items) page.refused.push_back(words(&each));
  return page;
}

/// Position of the map among all keys.
std::size_t position(std::string_view map_path) {
  const std::vector<Entry>& all = reference();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& entry) { return entry.path == map_path; });
  if (found == all.end()) throw std::logic_error(fmt::format("a page describes {}, which is no map of the deck", map_path));
  return static_cast<std::size_t>(found - all.begin());
}

bool is_within(std::string_view path, std::string_view map) { return path.starts_with(map) && (path.size() == map.size() || path[map.size()] == '.'); }

void add_missing(YamlNode& tree, const std::string& path, std::string_view value) {
  const YamlNode* node = &tree;
  for (const std::string_view key : keys_of(path)) {
    node = child(*node, key);
    if (!node) return set_value(tree, path, value, "the rest of the deck");
  }
}

std::vector<std::string> names_in(const YamlNode& tree, std::string_view key) {
  std::vector<std::string> names;
  if (const YamlNode* map = child(tree, key))
    for (const YamlNode::Entry& entry : map->entries) names.push_back(entry.key);
  return names;
}

void complete(YamlNode& tree) {
  add_missing(tree, "time", "{end: 10 ms}");
  add_missing(tree, "bodies", "{block: {}}");
  for (const std::string& name : names_in(tree, "bodies")) {
    const std::string path = "bodies." + name;
    add_missing(tree, path + ".shape", "{box: {size: [0.2, 0.1, 0.04]}}");
    const YamlNode* shape = child(*child(*child(tree, "bodies"), name), "shape");
    if (!child(*shape, "points") && !child(*shape, "cells")) add_missing(tree, path + ".spacing", "10 mm");
    add_missing(tree, path + ".material", "{model: ordinary-state, youngs_modulus: 9 GPa, density: 900}");
  }
  for (const std::string& name : names_in(tree, "impactors")) {
    const std::string path = "impactors." + name;
    add_missing(tree, path + ".surface", "{sphere: {diameter: 50 mm, edge_length: 5 mm}}");
    if (!child(*child(*child(tree, "impactors"), name), "density")) add_missing(tree, path + ".mass", "2 kg");
  }
}

}  // namespace

const std::vector<PageText>& page_texts() {
  static const std::vector<PageText> all = [] {
    std::vector<PageText> pages;
    for (const PageSource& source : page_sources()) pages.push_back(parse_page(source));
    std::sort(pages.begin(), pages.end(), [](const PageText& a, const PageText& b) { return position(a.maps.front()) < position(b.maps.front()); });
    return pages;
  }();
  return all;
}

const PageText* page_of(std::string_view map_path) {
  const PageText* found = nullptr;
  std::size_t longest = 0;
  for (const PageText& page : page_texts()) {
    for (const std::string& map : page.maps)
      if (map.size() > longest && is_within(map_path, map)) found = &page, longest = map.size();
  }
  return found;
}

Deck read_example(const Example& example, const std::filesystem::path& folder, std::span<const std::string> overrides) {
  YamlNode tree = parse_document(example.fragment, "example");
  complete(tree);
  for (const std::string& change : overrides) apply_override(tree, change);
  return deck_of_tree(std::move(tree), "example", folder);
}

}  // namespace perimpact::deck
