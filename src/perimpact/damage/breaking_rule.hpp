/// When a bond breaks, for ever: when its stretch s = (|η + ξ| - |ξ|)/|ξ| exceeds a critical value in tension (Silling and Askari, Comput. Struct.
/// 83 (2005) 1526) and, where asked for, falls below one in compression.
///
/// The literature that follows Madenci and Oterkus (2014) often tests |s|, so that bonds break in compression too; whether a paper does is
/// rarely said. Here compression breaks nothing unless a limit is given.
#pragma once

#include <optional>

namespace perimpact {

struct BreakingRule {
  double stretch;                     ///< [-] s_c > 0, in tension
  std::optional<double> compression;  ///< [-] positive: bonds break below -this; where absent, never in compression
};

}  // namespace perimpact
