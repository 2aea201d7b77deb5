/// Absorbing layer in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Absorbing layer: damping that increases with depth, against reflection of outgoing waves.
struct AbsorbingSetup {
  static constexpr std::string_view name = "absorbing";
  std::string particle_set;
  Choice face{face_words};   ///< outward normal of the end of the body
  double reflection = 1e-3;  ///< [-] reflection coefficient of the amplitude
  static std::span<const Field<AbsorbingSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
