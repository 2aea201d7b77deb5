/// Critical-stretch criterion for irreversible bond failure: the stretch s = (|η + ξ| - |ξ|)/|ξ| exceeds a critical value in tension (Silling and
/// Askari, Comput. Struct. 83 (2005) 1526) or, optionally, falls below one in compression.
///
/// The literature that follows Madenci and Oterkus (2014) often tests |s|, so that bonds break in compression too; papers rarely state this. Here
/// compression breaks no bond unless a limit is given.
///
/// The confinement-dependent critical stretch is s_c + α max(0, -s_min), with s_min the minimum stretch of the bonds of a particle: brittle solids
/// under compression sustain a larger transverse tension. (Rule of Silling's EMU for the prototype micro-elastic brittle material, as in LAMMPS,
/// pair_style peri/pmb, `alpha`; there a bond takes the smaller value of its two particles, here their mean.) Under uniform uniaxial compression,
/// transverse bonds break at ε = s_c/(ν - α). Free faces fail earlier: their layers separate by 0.37 ε for ν = 1/4, so that the compressive
/// strength of a body is 1/(0.37 - α) times its tensile strength (docs/theory/damage.md).
#pragma once

#include <optional>

namespace perimpact {

/// Parameters of the criterion.
struct BreakingRule {
  double stretch;                     ///< [-] s_c > 0, in tension
  std::optional<double> compression;  ///< [-] positive; bonds break at a stretch below -compression; absent: never in compression
  double hardening = 0;               ///< [-] α: s_c increases by α times the largest bond compression, mean of the two particles
};

}  // namespace perimpact
