/// JSON Schema of the deck (draft-07, https://json-schema.org/draft-07), generated from the tables and schema that also read it. Editors
/// with a YAML language server use it to complete keys, show their description and mark errors.
///
/// It covers single values and maps: keys, types, ranges of plain numbers, words, required keys and dependent keys. Units in text
/// ("9 mm"), contradictions between keys and files are left to `perimpact check`. It accepts every deck that runs, except those with
/// integers or booleans in quotes.
#pragma once

#include <string>

namespace perimpact::deck {

std::string json_schema();

}  // namespace perimpact::deck
