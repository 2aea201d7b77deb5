/// Floating in still water in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Weight, buoyancy, drag and added mass in still water (docs/theory/floating_bodies.md).
struct FloatingSetup {
  static constexpr std::string_view name = "floating";
  std::string particle_set;     ///< the whole body where empty
  std::optional<double> level;  ///< [m] z of the free surface; the equilibrium level of the initial position where absent
  double density = 1025;        ///< [kg/m³] of the water
  double gravity = 9.81;        ///< [m/s²]
  double drag = 1;              ///< [-] C_d of particles at the body's surface, referred to one of their faces
  double added_mass = 0;        ///< [-] of the displaced water, for vertical motion
  double entrained_depth = 0;   ///< [m] of the water that moves vertically with each column
  double dry_top = 0;           ///< [m] below the level, down to which the top of a whole column stays dry
  double damping = 0;           ///< [1/s] mass-proportional
  static std::span<const Field<FloatingSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
