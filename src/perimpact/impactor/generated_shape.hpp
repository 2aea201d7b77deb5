/// Hulls and propellers of a Setup as the shapes of the contact library, with what was left out filled in.
#pragma once

#include "marine/hull.hpp"
#include "marine/propeller.hpp"
#include "perimpact/deck_model/generated_surfaces.hpp"

namespace perimpact {

fccda::HullShape shape_of(const HullSurface& setup);

/// Throws InputError where ratios are missing beside the Wageningen series, or given beside sections.
fccda::PropellerShape shape_of(const PropellerSurface& setup);

}  // namespace perimpact
