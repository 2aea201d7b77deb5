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

TEST_CASE("ice: compressive strength is that of Timco and Frederking for the three kinds of ice") {
  // by hand: 1e-3^0.22 = 10^-0.66 = 0.218776; columnar √(30/270) = 1/3, along its columns √(50/200) = 1/2, granular √(70/280) = 1/2
  CHECK(ice_compressive_strength(IceStructure::columnar, 0.03, 1e-3) == fixtures::relative(37e6 * 0.218776 * 2 / 3, 1e-5));
  CHECK(ice_compressive_strength(IceStructure::columnar_vertical, 0.05, 1e-3) == fixtures::relative(160e6 * 0.218776 / 2, 1e-5));
  CHECK(ice_compressive_strength(IceStructure::granular, 0.07, 1e-3) == fixtures::relative(49e6 * 0.218776 / 2, 1e-5));
  // a tenth of the rate costs the factor 10^-0.22
  CHECK(ice_compressive_strength(IceStructure::columnar, 0.03, 1e-4) == fixtures::relative(0.602560 * 5.39648e6, 1e-5));
}
