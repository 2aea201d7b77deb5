/// Flexural strength and modulus of sea ice from its brine volume (docs/theory/ice.md).
///
///   ν_b = S (49.185/|T| + 0.532)/1000         Frankenstein and Garner, J. Glaciol. 6 (1967) 943; S [g/kg], T [°C] from -22.9 to -0.5
///   σ_f = 1.76 exp(-5.88 √ν_b) MPa            Timco and O'Brien, Cold Reg. Sci. Technol. 22 (1994) 285
///   E   = 10 (1 - 3.51 ν_b) - 1 GPa           Timco and Weeks, Cold Reg. Sci. Technol. 60 (2010) 107, less 1 GPa: the effective
///                                             modulus of Williams et al., Cold Reg. Sci. Technol. 91 (2013) 102
#pragma once

#include <cmath>

namespace perimpact {

/// Brine volume fraction [-]. `salinity` [g/kg], `temperature` [°C].
inline double brine_volume(double salinity, double temperature) { return 1e-3 * salinity * (49.185 / std::fabs(temperature) + 0.532); }

/// Flexural strength [Pa].
inline double ice_flexural_strength(double brine_volume) { return 1.76e6 * std::exp(-5.88 * std::sqrt(brine_volume)); }

/// Effective modulus [Pa]; negative, thus invalid, for brine volumes of 0.256 and more.
inline double ice_youngs_modulus(double brine_volume) { return 1e9 * (10 * (1 - 3.51 * brine_volume) - 1); }

}  // namespace perimpact
