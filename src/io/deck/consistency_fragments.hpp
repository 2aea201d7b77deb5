/// Consistency of contact.fragments.
#pragma once

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Throws InputError where contact parameters are given although law is none.
void check_fragments(const FragmentContactSetup& fragments, const Places& places);

}  // namespace perimpact::deck
