/// Consistency of an impactor: mass or density, prescribed motion, remeshing, elasticity, loads, gauges.
#pragma once

#include <filesystem>

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Fills in motion tables from files and the full path of the modes. Relative paths start at `folder`. Throws InputError at the position of the contradicting
/// value.
void make_impactor_consistent(ImpactorSetup& impactor, DetectorKind detector, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
