/// The deck as a JSON Schema (draft-07, https://json-schema.org/draft-07), from the same tables and schema that read it: editors with a
/// YAML language server complete keys with it, show their sentences and underline mistakes.
///
/// It says what can be said of one value and one map: keys, kinds, ranges of plain numbers, words, what is required and what goes with
/// what. Units of text ("9 mm"), contradictions between keys and everything about files are left to `perimpact check`. It refuses nothing
/// that runs, but for whole numbers and truth values in quotes.
#pragma once

#include <string>

namespace perimpact::deck {

std::string json_schema();

}  // namespace perimpact::deck
