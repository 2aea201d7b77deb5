/// Prescribed displacement in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Prescribed displacement or velocity of one direction, constant or tabulated against time.
struct DisplacementSetup : MotionTable {
  std::optional<double> velocity;      ///< [m/s] at all times
  std::optional<double> displacement;  ///< [m] at all times
  static std::span<const Field<DisplacementSetup>> fields();
};

/// Dirichlet condition: prescribed displacement history in some directions.
struct PrescribedSetup {
  static constexpr std::string_view name = "prescribed";
  std::string particle_set;  ///< the whole body where empty
  std::optional<DisplacementSetup> x, y, z;
  static std::span<const Field<PrescribedSetup>> fields();
  void check(BodyContext& deck);
  template <class Walker>
  static void sections(Walker& walk, PrescribedSetup& prescribed) {
    walk.section("x", prescribed.x, fccda::Presence::optional, "Prescribed motion of the particles along x.");
    walk.section("y", prescribed.y, fccda::Presence::optional, "Prescribed motion of the particles along y.");
    walk.section("z", prescribed.z, fccda::Presence::optional, "Prescribed motion of the particles along z.");
  }

  std::optional<DisplacementSetup>& of(std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const std::optional<DisplacementSetup>& of(std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

}  // namespace perimpact
