/// Hull and propeller shapes of a Setup, with defaults filled in.
#pragma once

#include "marine/hull.hpp"
#include "marine/propeller.hpp"
#include "perimpact/deck_model/generated_surfaces.hpp"

namespace perimpact {

fccda::HullShape shape_of(const HullSurface& setup);

/// Throws InputError if ratios are missing for the Wageningen series, or given together with sections.
fccda::PropellerShape shape_of(const PropellerSurface& setup);

}  // namespace perimpact
