/// The surface correction as the bond kernel sees it: numbers of particle i, loaded once, and a factor per bond.
#pragma once

#include <array>
#include <span>

#include "fccda/core/pack.hpp"
#include "perimpact/family/surface_correction.hpp"

namespace perimpact {

/// No factor at all.
struct PlainBonds {
  template <class Pack>
  struct OfParticle {};
  template <class Pack>
  OfParticle<Pack> of(std::size_t) const {
    return {};
  }
  template <class Pack>
  Pack corrected(Pack value, const OfParticle<Pack>&, std::size_t, std::ptrdiff_t) const {
    return value;
  }
};

/// Σ_p n_p² (g_p(i) + g_p(j))/2.
struct EnergyFactor {
  std::array<const double*, 3> g;
  std::span<const Vec3d> half_squares;  ///< n_p²/2 of each stencil bond

  template <class Pack>
  using OfParticle = fccda::Vec3<Pack>;
  template <class Pack>
  OfParticle<Pack> of(std::size_t slot) const {
    return {fccda::load<Pack>(g[0] + slot), fccda::load<Pack>(g[1] + slot), fccda::load<Pack>(g[2] + slot)};
  }
  template <class Pack>
  Pack corrected(Pack value, const OfParticle<Pack>& i, std::size_t bond, std::ptrdiff_t j) const {
    const Vec3d& w = half_squares[bond];
    Pack factor = Pack(w.x) * (i.x + fccda::load<Pack>(g[0] + j));
    factor = fccda::fused(Pack(w.y), i.y + fccda::load<Pack>(g[1] + j), factor);
    factor = fccda::fused(Pack(w.z), i.z + fccda::load<Pack>(g[2] + j), factor);
    return value * factor;
  }
};

/// 2 V₀/(V_i + V_j).
struct VolumeFactor {
  const double* half_volume;  ///< V/(2 V₀)

  template <class Pack>
  using OfParticle = Pack;
  template <class Pack>
  OfParticle<Pack> of(std::size_t slot) const {
    return fccda::load<Pack>(half_volume + slot);
  }
  template <class Pack>
  Pack corrected(Pack value, const OfParticle<Pack>& i, std::size_t, std::ptrdiff_t j) const {
    return value / (i + fccda::load<Pack>(half_volume + j));
  }
};

}  // namespace perimpact
