/// What contact.fragments says with itself.
#pragma once

#include "io/deck/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Throws InputError where fragments do not touch, but it is said how.
void check_fragments(const FragmentContactSetup& fragments, const Places& places);

}  // namespace perimpact::deck
