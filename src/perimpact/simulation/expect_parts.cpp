#include "perimpact/simulation/expect_parts.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

void expect_parts_for_all(const RanksInTurn& in_turn) {
  if (!in_turn.all_have_parts())
    throw SetupError("bodies", fmt::format("{} ranks are too many: the bodies can be divided among at most {}, since lattices are cut across x at multiples of "
                                           "eight cells only, and point clouds between blocks of eight particles. Use fewer.",
                                           in_turn.ranks(), in_turn.parts()));
}

}  // namespace perimpact
