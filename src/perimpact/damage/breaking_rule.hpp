/// When a bond breaks, for ever: when its stretch s = (|η + ξ| - |ξ|)/|ξ| exceeds a critical value in tension (Silling and Askari, Comput. Struct.
/// 83 (2005) 1526) and, where asked for, falls below one in compression.
///
/// The literature that follows Madenci and Oterkus (2014) often tests |s|, so that bonds break in compression too; whether a paper does is
/// rarely said. Here compression breaks nothing unless a limit is given.
///
/// Brittle solids stand more pull across where they are pressed together: s_c + α max(0, -s_min), s_min the least stretch of the bonds of a
/// particle (the rule of Silling's EMU for the prototype micro-elastic brittle material, as LAMMPS has it: pair_style peri/pmb, `alpha`; there
/// a bond takes the smaller value of its two particles, here their mean). Squeezed uniformly along one axis, bonds then break across
/// it at ε = s_c/(ν - α). Free faces break sooner: their layers part by 0.37 ε where ν = 1/4, so that the strength of a body is
/// 1/(0.37 - α) times that in tension (docs/theory/damage.md).
#pragma once

#include <optional>

namespace perimpact {

struct BreakingRule {
  double stretch;                     ///< [-] s_c > 0, in tension
  std::optional<double> compression;  ///< [-] positive: bonds break below -this; where absent, never in compression
  double hardening = 0;               ///< [-] α: s_c grows by this times the largest compression of a bond of the particles, mean of the two
};

}  // namespace perimpact
