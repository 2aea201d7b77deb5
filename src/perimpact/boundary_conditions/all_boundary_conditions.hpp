/// Variant of all boundary conditions, and a boundary condition with its name in the deck.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "perimpact/boundary_conditions/absorbing.hpp"
#include "perimpact/boundary_conditions/floating.hpp"
#include "perimpact/boundary_conditions/load.hpp"
#include "perimpact/boundary_conditions/prescribed_displacement.hpp"
#include "perimpact/boundary_conditions/user_force.hpp"

namespace perimpact {

using Boundary = std::variant<PrescribedDisplacement, Load, Floating, Absorbing, UserForce>;

struct NamedBoundaryCondition {
  std::string name;       ///< "plate.grip"
  std::string_view kind;  ///< "fixed", as in the deck; "user_force" for a user force
  Boundary boundary;

  std::size_t particles() const {
    return std::visit([](const auto& one) { return one.slots().size(); }, boundary);
  }

  ReactionLedger& account() {
    return std::visit([](auto& one) -> ReactionLedger& { return one.account; }, boundary);
  }
  const ReactionLedger& account() const { return const_cast<NamedBoundaryCondition&>(*this).account(); }
};

}  // namespace perimpact
