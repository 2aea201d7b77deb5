/// What the tables of the deck do not say, page by page of the deck reference: examples, restrictions, related pages
/// (src/io/deck/reference_pages/*.yaml).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/deck/deck.hpp"

namespace perimpact::deck {

struct Example {
  std::string caption;                                     ///< ends with a colon; may be empty
  std::string fragment;                                    ///< of a deck: at least the keys of the page, with the keys around them
  std::vector<std::pair<std::string, std::string>> files;  ///< name and contents of the files that it names
};

struct PageText {
  std::string name;  ///< of its file, without extension
  std::string title;
  std::string text;               ///< below the title
  std::vector<std::string> maps;  ///< it describes these maps of the deck and all within them that no other page describes
  std::vector<Example> examples;
  std::vector<std::vector<std::string>> refused;  ///< overrides "key.path=value" with which the reader refuses the first example
  std::vector<std::string> restrictions;          ///< those which are found only when the simulation is built
  std::vector<std::string> related;               ///< links in Markdown
};

/// All pages, in the order in which the deck reference lists their first map.
const std::vector<PageText>& page_texts();

/// The page that describes the map, or null for the top level.
const PageText* page_of(std::string_view map_path);

/// Reads the fragment together with whatever a deck requires beside it. Throws InputError as read_deck does.
Deck read_example(const Example& example, const std::filesystem::path& folder = {}, std::span<const std::string> overrides = {});

}  // namespace perimpact::deck
