/// Bond-based material in the deck model.
#pragma once

#include "perimpact/materials/elastic/setup.hpp"

namespace perimpact {

/// Bond-based material: independent bonds (micromodulus c); ν is 1/4, in plane stress 1/3.
struct BondBasedSetup : ElasticSetup {
  static constexpr std::string_view name = "bond-based";
  static constexpr bool may_yield = true;
  static std::span<const Field<BondBasedSetup>> fields();

  double poissons_ratio_in(Plane plane) const { return plane == Plane::stress ? 1.0 / 3 : 0.25; }
};

}  // namespace perimpact
