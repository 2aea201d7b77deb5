/// Constants of an isotropic linear elastic solid, 3-D or 2-D (plane stress, plane strain).
///
/// In 2-D they are those of a two-dimensional solid: plane stress keeps E and ν; plane strain has E/(1 - ν²) and ν/(1 - ν) instead
/// (Timoshenko and Goodier, Theory of Elasticity, 1970, art. 16). The formulas below apply to both.
#pragma once

namespace perimpact {

enum class Plane { none, stress, strain };

struct IsotropicElastic {
  double youngs_modulus;  ///< [Pa] E; of plane strain, E/(1 - ν²)
  double poissons_ratio;  ///< [-] ν; of plane strain, ν/(1 - ν)
  int dimension = 3;

  /// Constants for a material with these 3-D constants.
  static IsotropicElastic in(Plane plane, double youngs_modulus, double poissons_ratio) {
    if (plane == Plane::none) return {youngs_modulus, poissons_ratio, 3};
    if (plane == Plane::stress) return {youngs_modulus, poissons_ratio, 2};
    return {youngs_modulus / (1 - poissons_ratio * poissons_ratio), poissons_ratio / (1 - poissons_ratio), 2};
  }

  constexpr double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }  ///< [Pa] µ
  /// [Pa] κ: E/(3 (1 - 2ν)) in 3-D, E/(2 (1 - ν)) in 2-D.
  constexpr double bulk_modulus() const { return youngs_modulus / (dimension * (1 - (dimension - 1) * poissons_ratio)); }
  constexpr double lame_modulus() const { return bulk_modulus() - 2.0 / dimension * shear_modulus(); }  ///< [Pa] λ
  constexpr double p_wave_modulus() const { return lame_modulus() + 2 * shear_modulus(); }              ///< [Pa] λ + 2µ
};

}  // namespace perimpact
