/// Conversion of a set-up of Python dicts, lists, numbers and strings to the tree from which a deck is read, so that both share keys, units,
/// checks and messages. Messages for a set-up give the key in place of line and column.
#pragma once

#include <string>

#include "arrays.hpp"
#include "io/deck/deck.hpp"

namespace perimpact::python {

/// Adds the meshes of the set-up to `surfaces` and refers to them by name. Throws InputError for types that a set-up does not support.
deck::YamlNode tree_of(const py::handle& value, const std::string& place, deck::SurfacesInMemory& surfaces);

/// Applies overrides of the form {"key.path": value} in order, as --set does; strings are parsed as YAML.
void change(deck::YamlNode& tree, const py::dict& changes, deck::SurfacesInMemory& surfaces);

}  // namespace perimpact::python
