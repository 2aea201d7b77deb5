/// Reads a deck (YAML) into the Setup of a simulation.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/surface_files.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

struct Deck {
  Setup setup;
  Places places;                      ///< "bodies.plate.spacing" → "deck.yaml:7:14"
  std::vector<std::string> warnings;  ///< one sentence per deprecated key
};

/// Reads a deck with overrides "key.path=value", applied in order. Relative file names start at the deck's folder. Throws InputError,
/// one sentence with file, line and column: for invalid YAML, unknown, missing and duplicate keys, wrong types and units, values out of
/// range, and contradictions (consistency.hpp).
Deck read_deck(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same from text. `name`: of the deck in messages; `folder`: start of relative file names.
Deck read_deck_text(std::string_view text, const std::string& name, const std::filesystem::path& folder, std::span<const std::string> overrides = {});

/// The unchecked YAML tree of a deck. Throws InputError for a file that cannot be read and for invalid YAML.
YamlNode read_deck_tree(const std::filesystem::path& file);

/// The same from a tree, read or generated, whose places give the origin of each value. `surfaces` may be named instead of surface files.
Deck deck_of_tree(YamlNode document, const std::string& name, const std::filesystem::path& folder, const SurfacesInMemory& surfaces = {});

}  // namespace perimpact::deck
