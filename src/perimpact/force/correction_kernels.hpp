/// Surface effect correction for the bond kernel: values of particle i, loaded once, and a factor per bond.
#pragma once

#include <array>
#include <span>

#include "base/contract.hpp"
#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "perimpact/family/surface_correction.hpp"

namespace perimpact {

/// No correction.
struct PlainBonds {
  template <class Visit>
  void visit_pointers(const Visit&) {}
  template <class Pack>
  struct OfParticle {};
  template <class Pack>
  FCCDA_HD OfParticle<Pack> of(std::size_t) const {
    return {};
  }
  template <class Pack, class Neighbour>
  FCCDA_HD Pack corrected(Pack value, const OfParticle<Pack>&, std::size_t, const Neighbour&) const {
    return value;
  }
};

/// Energy-based correction: Σ_p n_p² (g_p(i) + g_p(j))/2.
struct EnergyFactor {
  std::array<const double*, 3> g;
  const Vec3d* half_squares;  ///< n_p²/2 of each stencil bond

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    for (const double*& of_axis : g) visit(of_axis);
    visit(half_squares);
  }
  template <class Pack>
  using OfParticle = fccda::Vec3<Pack>;
  template <class Pack>
  FCCDA_HD OfParticle<Pack> of(std::size_t slot) const {
    return {fccda::load<Pack>(g[0] + slot), fccda::load<Pack>(g[1] + slot), fccda::load<Pack>(g[2] + slot)};
  }
  template <class Pack, class Neighbour>
  FCCDA_HD Pack corrected(Pack value, const OfParticle<Pack>& i, std::size_t bond, const Neighbour& j) const {
    const Vec3d& w = half_squares[bond];
    Pack factor = Pack(w.x) * (i.x + j.of(g[0]));
    factor = fccda::fused_multiply_add(Pack(w.y), i.y + j.of(g[1]), factor);
    factor = fccda::fused_multiply_add(Pack(w.z), i.z + j.of(g[2]), factor);
    return value * factor;
  }
};

/// Volume-based correction: 2 V₀/(V_i + V_j).
struct VolumeFactor {
  const double* half_volume;  ///< V/(2 V₀)

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(half_volume);
  }
  template <class Pack>
  using OfParticle = Pack;
  template <class Pack>
  FCCDA_HD OfParticle<Pack> of(std::size_t slot) const {
    return fccda::load<Pack>(half_volume + slot);
  }
  template <class Pack, class Neighbour>
  FCCDA_HD Pack corrected(Pack value, const OfParticle<Pack>& i, std::size_t, const Neighbour& j) const {
    return value / (i + j.of(half_volume));
  }
};

/// Correction by the weighted volume of each family: (g_i + g_j)/2, g = m/m_i.
struct FamilyFactor {
  const double* half;  ///< g/2

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(half);
  }
  template <class Pack>
  using OfParticle = Pack;
  template <class Pack>
  FCCDA_HD OfParticle<Pack> of(std::size_t slot) const {
    return fccda::load<Pack>(half + slot);
  }
  template <class Pack, class Neighbour>
  FCCDA_HD Pack corrected(Pack value, const OfParticle<Pack>& i, std::size_t, const Neighbour& j) const {
    return value * (i + j.of(half));
  }
};

/// Factors of the stretch and dilatation terms of a bond, and of the dilatation of a particle.
template <class Stretch, class Dilatation, bool by_family = false>
struct Corrections {
  Stretch stretch;
  Dilatation dilatation;
  const double* half_of_family = nullptr;

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    stretch.visit_pointers(visit), dilatation.visit_pointers(visit);
    visit(half_of_family);
  }
  /// g θ, the dilatation in bond forces, where θ = g Σ is the dilatation (by_family); else θ = Σ.
  template <class Pack>
  FCCDA_HD Pack pushing(Pack sum, std::size_t slot) const {
    if constexpr (!by_family) return sum;
    const Pack half = fccda::load<Pack>(half_of_family + slot);
    return sum * (half + half) * (half + half);
  }
  /// The dilatation θ, from the result of `pushing`.
  template <class Pack>
  FCCDA_HD Pack dilatation_of(Pack pushing, std::size_t slot) const {
    if constexpr (!by_family) return pushing;
    const Pack half = fccda::load<Pack>(half_of_family + slot);
    return pushing / (half + half);
  }
};

using NoCorrections = Corrections<PlainBonds, PlainBonds>;

/// Calls f(corrections) with those of the bonds of a stencil. `half_squares`: n_p²/2 of each. Not for CorrectionKind::family, which acts on the sums of
/// particles too.
template <class F>
void with_bond_corrections(const CorrectionFactors& correction, std::span<const Vec3d> half_squares, const F& f) {
  EXPECTS(correction.kind() != CorrectionKind::family);
  if (correction.kind() == CorrectionKind::energy) {
    f(Corrections<EnergyFactor, EnergyFactor>{{correction.stretch().pointers(), half_squares.data()},
                                              {correction.dilatation().pointers(), half_squares.data()}});
  } else if (correction.kind() == CorrectionKind::volume) {
    const VolumeFactor factor{correction.volume().component(0)};
    f(Corrections<VolumeFactor, VolumeFactor>{factor, factor});
  } else {
    f(NoCorrections{});
  }
}

/// Calls per_pack(body, slot, corrections) for a pack; with a table of factors these are in the constants, and there are no corrections.
template <class View, class Correction, class PerPack>
FCCDA_HD auto with_factors(const View& body, std::size_t slot, const Correction& corrections, const PerPack& per_pack) {
  const std::int32_t table = body.table_of[slot / fccda::byte_lanes];
  return table == CorrectionFactors::no_table ? per_pack(body, slot, corrections) : per_pack(body.with(body.constants.of_table(table)), slot, NoCorrections{});
}

}  // namespace perimpact
