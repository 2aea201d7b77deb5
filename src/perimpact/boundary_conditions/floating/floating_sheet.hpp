/// Lengths of an elastic sheet on water, from which users choose the depth of water that it entrains (docs/theory/floating_bodies.md).
#pragma once

#include <cmath>

#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

/// [m] (D/(ρ_w g))^¼ with the bending stiffness D of a plate of that thickness [m]; `foundation`: ρ_w g [N/m³]. It is 1/k of the wave whose bending
/// stiffness D k⁴ equals that of the water, and entrains the water of that depth.
inline double characteristic_length(const IsotropicElastic& elastic, double thickness, double foundation) {
  const double stiffness = elastic.youngs_modulus * thickness * thickness * thickness / (12 * (1 - elastic.poissons_ratio * elastic.poissons_ratio));
  return std::pow(stiffness / foundation, 0.25);
}

}  // namespace perimpact
