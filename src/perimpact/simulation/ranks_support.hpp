/// What a run of several ranks does not support: parts of a deck, and more ranks than its bodies can be divided among.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/partition.hpp"

namespace perimpact {

/// Throws SetupError with the key of the first part of the deck that several ranks do not support. Does nothing for one rank.
void expect_supported_by(int ranks, const Setup& setup);

/// Throws SetupError if a rank would have no part of any body. `in_turn`: after all bodies.
void expect_parts_for_all(const RanksInTurn& in_turn);

}  // namespace perimpact
