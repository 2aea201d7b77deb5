/// The reference of the deck, from the tables that read it.
#pragma once

#include <string>
#include <string_view>

namespace perimpact::deck {

/// What a deck may say, as plain text: all of it for an empty path, else the keys that the path ends in with all below them.
/// Names may be left out or be any: "bodies.material.poissons_ratio", "bodies.plate.material" and "poissons_ratio" all work.
/// Throws InputError with a suggestion for an unknown key.
std::string describe(std::string_view key_path);

/// The whole reference in markdown: docs/guide/deck_reference.md.
std::string describe_markdown();

}  // namespace perimpact::deck
