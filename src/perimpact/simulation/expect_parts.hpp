/// More ranks than the bodies of a deck can be divided among.
#pragma once

#include "perimpact/particles/partition.hpp"

namespace perimpact {

/// Throws SetupError if a rank would have no part of any body. `in_turn`: after all bodies.
void expect_parts_for_all(const RanksInTurn& in_turn);

}  // namespace perimpact
