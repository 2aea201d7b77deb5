/// Plasticity in the deck model: an option of the materials that state `may_yield`.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/parameter.hpp"
#include "perimpact/materials/plasticity/plasticity.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;

struct BodyContext;
struct ElasticSetup;

inline constexpr std::string_view yield_surface_words[] = {"riska-frederking", "derradji-aouat", "kierkegaard", "von-mises"};
static_assert(fccda::are_enumerators<YieldSurface>(yield_surface_words));

/// Plastic flow under pressure (docs/theory/ice_plasticity.md).
struct PlasticitySetup {
  Choice surface{yield_surface_words};
  std::optional<double> compressive_strength;  ///< [Pa] uniaxial, to which the surface is scaled
  double failure_strain = 0.01;                ///< [-] ε0
  double failure_width = 1;                    ///< [-] M
  double failure_pressure = 0.75;              ///< [-] N
  std::optional<double> friction_angle;        ///< [rad] φ of ice that has failed
  static std::span<const Field<PlasticitySetup>> fields();

  /// Throws SetupError unless the material, and the failure of its body, permit it.
  void check(const ElasticSetup& material, const BodyContext& deck) const;
};

}  // namespace perimpact
