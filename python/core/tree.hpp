/// A set-up in Python's dicts, lists, numbers and words as the tree that a deck is read from, so that both go through the same tables: the same keys, units,
/// checks and sentences. Where a deck's message names line and column, that of a set-up names the key.
#pragma once

#include <string>

#include "arrays.hpp"
#include "io/deck/deck.hpp"

namespace perimpact::python {

/// Throws InputError for what has no place in a set-up.
deck::YamlNode tree_of(const py::handle& value, const std::string& place);

/// Changes of the form {"key.path": value}, in order, as --set makes them: words are read as YAML there too.
void change(deck::YamlNode& tree, const py::dict& changes);

}  // namespace perimpact::python
