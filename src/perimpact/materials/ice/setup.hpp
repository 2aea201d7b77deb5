/// Ice in the deck model: source of modulus and strength, for any material.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/parameter.hpp"
#include "perimpact/materials/ice/ice.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;

struct BodyContext;
struct ElasticSetup;

inline constexpr std::string_view ice_structure_words[] = {"columnar", "columnar-vertical", "granular"};
static_assert(fccda::are_enumerators<IceStructure>(ice_structure_words));

/// Ice by temperature and salinity, in place of modulus and strength (docs/theory/ice.md).
struct IceSetup {
  std::optional<double> temperature;   ///< [°C] mean over the thickness
  std::optional<double> salinity;      ///< [g/kg]
  std::optional<double> brine_volume;  ///< [-] brine volume fraction; in place of the other two
  std::optional<double> thickness;     ///< [m] in bending; determines the number of layers
  std::optional<double> strain_rate;   ///< [1/s] of the compressive strength
  double air_volume = 0;               ///< [-] air volume fraction
  Choice structure{ice_structure_words};
  static std::span<const Field<IceSetup>> fields();

  /// Sets modulus, strengths and layers of the material where the deck gives none.
  void apply(ElasticSetup& material, const BodyContext& deck) const;

 private:
  void apply_strain_rate(ElasticSetup& material, double brine, const BodyContext& deck) const;
};

}  // namespace perimpact
