/// The list of what a boundary condition can be, and one under its name in the deck.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "perimpact/boundary/absorbing.hpp"
#include "perimpact/boundary/floating.hpp"
#include "perimpact/boundary/held.hpp"
#include "perimpact/boundary/load.hpp"
#include "perimpact/boundary/own_force.hpp"

namespace perimpact {

using Boundary = std::variant<Held, Load, Floating, Absorbing, OwnForce>;

struct NamedBoundary {
  std::string name;       ///< "plate.grip"
  std::string_view kind;  ///< "fixed", as in the deck; "own_force" where code gave it
  Boundary boundary;

  std::size_t particles() const {
    return std::visit([](const auto& one) { return one.slots().size(); }, boundary);
  }

  BoundaryAccount& account() {
    return std::visit([](auto& one) -> BoundaryAccount& { return one.account; }, boundary);
  }
  const BoundaryAccount& account() const { return const_cast<NamedBoundary&>(*this).account(); }
};

}  // namespace perimpact
