/// Strength of particles under compression, where the critical stretch increases with it (docs/theory/failure.md).
#pragma once

#include <array>
#include <cstddef>

#include "base/host_device.hpp"
#include "perimpact/damage/breaking_rule.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact {

/// Minimum bond stretch s_min of the particles of a pack, at most 0. `x`: components of the current positions.
template <class Pack, class Bonds, class Lengths>
FCCDA_HD Pack least_stretch(const Bonds& bonds, const Lengths& lengths, const std::array<const double*, 3>& x, std::size_t slot) {
  Pack most(0.0);  // 1 - |η + ξ|²/|ξ|², which increases as the stretch decreases
  for_each_bond<Pack>(bonds, x, slot, Unbreakable{}, [&](const auto& bond) {
    const Pack length = lengths.template length<Pack>(bond.index);
    most = fccda::larger(most, bond.where_intact(Pack(1.0) - bond.squared_length / (length * length)));
  });
  const Pack squared = fccda::larger(Pack(1.0) - most, Pack(1e-12));  // lower bound for bonds of zero length
  return squared * fccda::inverse_square_root(squared) - Pack(1.0);
}

/// Derivative of k/2 of a particle with respect to s_min [-].
inline double hardening_slope(const BreakingRule& rule) { return -0.5 * rule.hardening / rule.stretch; }

/// k/2 [-] of the particles of a pack under the compression at the positions `x`. `slope`: hardening_slope(); `unpressed`: k/2 of all slots without
/// compression; null where it is 1/2.
template <class Pack, class Bonds, class Lengths>
FCCDA_HD Pack half_strength_under_pressure(const Bonds& bonds, const Lengths& lengths, const std::array<const double*, 3>& x, std::size_t slot, double slope,
                                           const double* unpressed) {
  return fccda::fused_multiply_add(Pack(slope), least_stretch<Pack>(bonds, lengths, x, slot), unpressed ? fccda::load<Pack>(unpressed + slot) : Pack(0.5));
}

}  // namespace perimpact
