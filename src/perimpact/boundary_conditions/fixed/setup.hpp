/// Fixed particles in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Homogeneous Dirichlet condition: zero displacement in some directions.
struct FixedSetup {
  static constexpr std::string_view name = "fixed";
  std::string particle_set;             ///< the whole body where empty
  std::vector<std::string> directions;  ///< of x, y, z; all where empty
  static std::span<const Field<FixedSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
