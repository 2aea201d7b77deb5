/// Surface files of a deck.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "mesh/named_panels.hpp"
#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Panels that may replace surface files, by name.
using SurfacesInMemory = std::map<std::string, fccda::NamedPanels, std::less<>>;

/// Gives the surfaces of impactors, bodies and solids full paths, relative ones starting at `folder`, or the panels of that name. Throws InputError at the
/// place of a file that does not exist.
void find_surfaces(Setup& setup, const std::filesystem::path& folder, const SurfacesInMemory& in_memory, const Places& places);

/// The panels that a set-up has instead of surface files.
SurfacesInMemory surfaces_in_memory(const Setup& setup);

}  // namespace perimpact::deck
