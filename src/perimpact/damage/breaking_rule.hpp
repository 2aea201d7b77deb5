/// When a bond breaks, for ever: when its stretch s = (|η + ξ| - |ξ|)/|ξ| exceeds a critical value in tension (Silling and Askari, Comput. Struct.
/// 83 (2005) 1526) and, where asked for, falls below one in compression.
///
/// The literature that follows Madenci and Oterkus (2014) often tests |s|, so that bonds break in compression too; whether a paper does is
/// rarely said. Here compression breaks nothing unless a limit is given.
///
/// Brittle solids stand more pull across where they are pressed together: s_c + α max(0, -s_min), s_min the least stretch of the bonds of a
/// particle (the rule of Silling's EMU for the prototype micro-elastic brittle material, as LAMMPS has it: pair_style peri/pmb, `alpha`; there
/// a bond takes the smaller value of its two particles, here their mean). Squeezed along one axis, a body then breaks across it at
/// ε = s_c/(ν - α): its strength in compression is 1/(ν - α) times that in tension, and for α >= ν it never breaks so.
#pragma once

#include <optional>

namespace perimpact {

struct BreakingRule {
  double stretch;                     ///< [-] s_c > 0, in tension
  std::optional<double> compression;  ///< [-] positive: bonds break below -this; where absent, never in compression
  double hardening = 0;               ///< [-] α: s_c grows by this times the largest compression of a bond of the particles, mean of the two
};

}  // namespace perimpact
