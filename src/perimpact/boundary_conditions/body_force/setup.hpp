/// Body force in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Body force density: weight, inertia of an accelerated frame, or traction spread over a layer.
struct BodyForceSetup {
  static constexpr std::string_view name = "body_force";
  std::string particle_set;   ///< the whole body where empty
  Vec3d force_density{};      ///< [N/m³]
  std::vector<double> times;  ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<BodyForceSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
