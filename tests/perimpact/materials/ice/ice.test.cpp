#include "perimpact/materials/ice/ice.hpp"

#include <doctest/doctest.h>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

TEST_CASE("ice: brine, strength and modulus are those of the published formulas") {
  // by hand, five digits: 5 g/kg at -5 degC: 5 (9.837 + 0.532) = 51.845 parts in a thousand; 1.76 exp(-5.88 0.227695) MPa; 10 (1 - 0.181976) - 1 GPa
  CHECK(brine_volume(5, -5) == fixtures::relative(0.051845, 1e-12));
  CHECK(ice_flexural_strength(0.051845) == fixtures::relative(0.46137e6, 1e-4));
  CHECK(ice_youngs_modulus(0.051845) == fixtures::relative(7.18024e9, 1e-5));
  // without brine
  CHECK(ice_flexural_strength(0) == 1.76e6);
  CHECK(ice_youngs_modulus(0) == 9e9);
}
