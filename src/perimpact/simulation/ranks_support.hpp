/// What a run of several ranks does not support.
#pragma once

#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// Throws SetupError with the key of the first part of the deck that several ranks do not support. Does nothing for one rank.
void expect_supported_by(int ranks, const Setup& setup);

}  // namespace perimpact
