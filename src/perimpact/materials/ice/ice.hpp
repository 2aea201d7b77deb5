/// Flexural strength, modulus and compressive strength of sea ice from its brine volume (docs/theory/ice.md).
///
///   ν_b = S (49.185/|T| + 0.532)/1000         Frankenstein and Garner, J. Glaciol. 6 (1967) 943; S [g/kg], T [°C] from -22.9 to -0.5
///   σ_f = 1.76 exp(-5.88 √ν_b) MPa            Timco and O'Brien, Cold Reg. Sci. Technol. 22 (1994) 285
///   E   = 10 (1 - 3.51 ν_b) - 1 GPa           Timco and Weeks, Cold Reg. Sci. Technol. 60 (2010) 107, less 1 GPa, the effective
///                                             modulus for floes that waves bend, in public code (docs/theory/ice.md)
///   σ_c = A ε̇^0.22 (1 - √(ν_T/B))             Timco and Frederking, Cold Reg. Sci. Technol. 17 (1990) 227; ν_T with air, ε̇ [1/s] from 1e-7 to 1e-3
#pragma once

#include <cmath>

namespace perimpact {

/// Brine volume fraction [-]. `salinity` [g/kg], `temperature` [°C].
inline double brine_volume(double salinity, double temperature) { return 1e-3 * salinity * (49.185 / std::fabs(temperature) + 0.532); }

/// Flexural strength [Pa].
inline double ice_flexural_strength(double brine_volume) { return 1.76e6 * std::exp(-5.88 * std::sqrt(brine_volume)); }

/// Effective modulus [Pa]; negative, thus invalid, for brine volumes of 0.256 and more.
inline double ice_youngs_modulus(double brine_volume) { return 1e9 * (10 * (1 - 3.51 * brine_volume) - 1); }

enum class IceStructure { columnar, columnar_vertical, granular };

/// A and B of σ_c.
struct CrushingFit {
  double factor;         ///< [Pa] at 1/s
  double most_porosity;  ///< [-] at which no strength is left
};
constexpr CrushingFit crushing_fit(IceStructure structure) {
  switch (structure) {
    case IceStructure::columnar_vertical:
      return {160e6, 0.2};
    case IceStructure::granular:
      return {49e6, 0.28};
    default:
      return {37e6, 0.27};
  }
}
inline constexpr double slowest_crushing = 1e-7, fastest_crushing = 1e-3;  ///< [1/s] of the tests

/// Uniaxial compressive strength [Pa]. `porosity` [-] of brine and air, below the largest of the fit; `strain_rate` [1/s].
inline double ice_compressive_strength(IceStructure structure, double porosity, double strain_rate) {
  const CrushingFit fit = crushing_fit(structure);
  return fit.factor * std::pow(strain_rate, 0.22) * (1 - std::sqrt(porosity / fit.most_porosity));
}

}  // namespace perimpact
