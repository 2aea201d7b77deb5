/// Consistency of a body's material, failure and bending calibration.
#pragma once

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Sets the values that follow from `ice` and are not given in the deck. Throws InputError.
void make_material_consistent(BodySetup& body, bool is_quasi_static, const Places& places);

}  // namespace perimpact::deck
