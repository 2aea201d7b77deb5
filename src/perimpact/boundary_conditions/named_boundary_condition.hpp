/// Variant of all boundary conditions, and a boundary condition with its name in the deck.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "base/typelist.hpp"
#include "perimpact/boundary_conditions/actions/user_force.hpp"
#include "perimpact/boundary_conditions/all_boundary_conditions.hpp"
#include "perimpact/boundary_conditions/all_setups.hpp"

namespace perimpact {

/// The actions on particles of all boundary conditions of the deck: what make_boundary() of each returns.
template <class Setups>
struct ActionsOf;
template <class... Setups>
struct ActionsOf<std::variant<Setups...>> {
  using type = fccda::JoinedVariant<decltype(make_boundary(std::declval<const Setups&>(), std::declval<const BoundarySite&>()))..., UserForce>;
};

using Boundary = ActionsOf<BoundaryConditionKind>::type;

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
