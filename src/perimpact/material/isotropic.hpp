/// Constants of an isotropic linear elastic solid.
#pragma once

namespace perimpact {

struct IsotropicElastic {
  double youngs_modulus;  ///< [Pa] E
  double poissons_ratio;  ///< [-] ν

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }        ///< [Pa] µ
  double bulk_modulus() const { return youngs_modulus / (3 * (1 - 2 * poissons_ratio)); }     ///< [Pa] κ
  double p_wave_modulus() const { return bulk_modulus() + 4.0 / 3.0 * shear_modulus(); }      ///< [Pa] λ + 2µ
};

}  // namespace perimpact
