/// What the keys of an impactor say together: mass or density, motion against time, changed panels, loads, gauges.
#pragma once

#include <filesystem>

#include "io/deck/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Fills in the tables of motion that are in files, of which relative paths start at `folder`. Throws InputError at the place of what
/// contradicts something else.
void make_impactor_consistent(ImpactorSetup& impactor, DetectorKind detector, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
