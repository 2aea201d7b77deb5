/// Consistency of keys across the deck: derived values are filled in, contradictions are refused.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "io/deck/surface_files.hpp"
#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Keys of a body that `published: true` sets and that must therefore be absent with it.
inline constexpr std::array<std::string_view, 3> set_by_published = {"family", "normalisation", "surface_correction"};

/// Fills in the discretisation of published bodies, radius_ratio 0 for the published detector, the full paths of surface files and the
/// tables of motion files. Relative paths start at `folder`. Throws InputError at the position of the contradicting value.
void make_consistent(Setup& setup, const Places& places, const std::filesystem::path& folder, const SurfacesInMemory& surfaces);

}  // namespace perimpact::deck
