/// Explains keys on the terminal, from the tables that also read the deck.
#pragma once

#include <string>
#include <string_view>

namespace perimpact::deck {

/// The reference as plain text: all keys for an empty path, else the keys at the end of the path with all keys below them.
/// Names may be omitted or arbitrary: "bodies.material.poissons_ratio", "bodies.plate.material" and "poissons_ratio" all work.
/// Throws InputError with a suggestion for an unknown key.
std::string describe(std::string_view key_path);

}  // namespace perimpact::deck
