/// From a deck (YAML) to the Setup of a simulation.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/places.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

struct Deck {
  Setup setup;
  Places places;                      ///< "bodies.plate.spacing" → "deck.yaml:7:14"
  std::vector<std::string> warnings;  ///< deprecated keys, a sentence each
};

/// Reads a deck with changes of the form "key.path=value", applied in order. Relative file names in it start at the deck's folder.
/// Throws InputError, one sentence with file, line and column, for all that cannot be used: YAML that cannot be read, unknown,
/// missing and duplicate keys, wrong types and units, values out of range, and contradictions (consistency.hpp).
Deck read_deck(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same from text. `name`: how messages call it; `folder`: where relative file names start.
Deck read_deck_text(std::string_view text, const std::string& name, const std::filesystem::path& folder, std::span<const std::string> overrides = {});

/// A deck as a tree, before anything in it is checked. Throws InputError for a file that cannot be read, and YAML likewise.
YamlNode read_deck_tree(const std::filesystem::path& file);

/// The same from a tree, read or made by code, whose places say where each value comes from.
Deck deck_of_tree(YamlNode document, const std::string& name, const std::filesystem::path& folder);

}  // namespace perimpact::deck
