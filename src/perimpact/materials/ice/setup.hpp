/// Ice in the deck model: source of modulus and strength, for any material.
#pragma once

#include <optional>
#include <span>

#include "base/parameter.hpp"

namespace perimpact {

using fccda::Field;

struct BodyContext;
struct ElasticSetup;

/// Ice by temperature and salinity, in place of modulus and strength (docs/theory/ice.md).
struct IceSetup {
  std::optional<double> temperature;   ///< [°C] mean over the thickness
  std::optional<double> salinity;      ///< [g/kg]
  std::optional<double> brine_volume;  ///< [-] brine volume fraction; in place of the other two
  std::optional<double> thickness;     ///< [m] in bending; determines the number of layers
  static std::span<const Field<IceSetup>> fields();

  /// Sets modulus, strength and layers of the material where the deck gives none.
  void apply(ElasticSetup& material, const BodyContext& deck) const;
};

}  // namespace perimpact
