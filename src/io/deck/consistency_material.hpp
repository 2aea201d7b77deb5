/// What the keys of a body's material, failure and bending must have to do with one another.
#pragma once

#include "io/deck/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Sets what `ice` says and the deck does not. Throws InputError.
void make_material_consistent(BodySetup& body, const Places& places);

}  // namespace perimpact::deck
