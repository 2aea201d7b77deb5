/// Surface effect correction: particles near a surface lack bonds, so that the body is too soft there. Each bond is multiplied by a factor
/// from numbers of its two particles; nothing is stored per bond of a lattice. Factors do not change when bonds break.
///
/// energy  (after Madenci and Oterkus 2014, ch. 4.2; default): uniaxial tension along each axis p, and a unit strain along it, give
///         numbers g_p = (sum of a complete family)/(sum of this family), once for the bonds' energy Σ ω_e e² v V and once for the
///         dilatation Σ ω_θ |ξ| e v V. A bond's factor is Σ_p n_p² (g_p(i) + g_p(j))/2: no root, no division in the kernel, where they take the
///         ellipsoid 1/√Σ_p (n_p/g_p)². Theirs is the smaller of the two means. Both leave thin bodies too stiff, because a bond
///         between a surface particle and an inner one is corrected for both: a bar of 10 × 10 particles by 7 % (theirs 6 %). The g_p
///         of all particles with such bonds are therefore improved `sweeps` times by the remaining ratio: under 1 % on that bar after
///         four. More sweeps reduce the bending stiffness (six layers: 0.92 of the classical value without, 0.91 after four, 0.90 after
///         eight), and the factors begin to alternate between particles.
///         In a point cloud no family is complete, so that all particles are corrected, also for its irregularity.
/// volume  (Le and Bobaru, Comput. Mech. 61 (2018) 499): 2 V₀/(V_i + V_j) with V = Σ v V, V₀ that of a complete family.
/// family  (linear peridynamic solid): every particle is normalised by its own weighted volume m_i; g_i = m/m_i multiplies its dilatation, and
///         (g_i + g_j)/2 its bonds.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "perimpact/family/family.hpp"

namespace perimpact {

enum class CorrectionKind { none, energy, volume, family };

/// Material data for corrections.
struct CorrectionBasis {
  double poissons_ratio;                            ///< in 2-D, the effective one
  std::function<double(double)> dilatation_weight;  ///< [m²] ω_θ |ξ|² by length; empty if the material has no use for the factors of the dilatation
  std::function<double(double)> stretch_weight;     ///< [m²] ω_e |ξ|² by length
  double volume, weighted, dilatation, energy;      ///< of a complete family: FamilySums (materials)
};

/// The two factors of a bond [-].
struct BondFactors {
  double stretch = 1, dilatation = 1;
  bool operator==(const BondFactors&) const = default;
};

class CorrectionFactors {
 public:
  /// Factors of the body with its holes, before cracks are cut.
  CorrectionFactors(CorrectionKind kind, const CorrectionBasis& basis, const Family& family, const Particles& particles);

  static constexpr int sweeps = 4;  ///< of the energy correction

  CorrectionKind kind() const { return kind_; }
  const VectorArray& stretch() const { return stretch_; }  ///< g_p of the bonds' energy [-]
  /// g_p of the dilatation [-]; without a dilatation those of the energy, which a kernel may load and does not use.
  const VectorArray& dilatation() const { return dilatation_.slots() != 0 ? dilatation_ : stretch_; }
  const ScalarArray& volume() const { return volume_; }          ///< V/(2 V₀) [-]
  const ScalarArray& own_family() const { return own_family_; }  ///< g/2 [-]

  /// Tables of the factors of all bonds of a stencil. The first is that of complete families: all 1. Within rows of a box, packs of eight
  /// neighbours share the same factors bond by bond, also across rows; a table then replaces the numbers of particles.
  const std::vector<std::vector<BondFactors>>& tables() const { return tables_; }
  static constexpr std::int32_t no_table = -1;
  /// The table of slots 8·eight … 8·eight + 7, or no_table if their factors differ or too few packs share them.
  std::int32_t table_of(std::size_t eight) const { return table_of_[eight]; }
  std::span<const std::int32_t> table_of() const { return table_of_; }  ///< of all eights

  /// The factors of one bond, as the kernel computes them. `weights`: interpolation_weights of its direction.
  double stretch_factor(std::size_t i, std::size_t j, const Vec3d& weights) const;
  double dilatation_factor(std::size_t i, std::size_t j, const Vec3d& weights) const;  ///< of energy with a dilatation, and of volume; else 1

  /// Calls visit(span) for each array that the kernels read.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    for (const VectorArray* factors : {&stretch_, &dilatation_}) visit(factors->with_slack());
    for (const ScalarArray* factors : {&volume_, &own_family_}) visit(factors->with_slack());
    visit(std::span(table_of_));
  }
  double bytes() const;  ///< [bytes] of memory

 private:
  void balance_energy(const CorrectionBasis& basis, const Family& family, const Particles& particles, const std::vector<std::uint8_t>& changed);
  void weigh_volume(const CorrectionBasis& basis, const Family& family, const Particles& particles);
  void weigh_own_family(const CorrectionBasis& basis, const Family& family, const Particles& particles);

  void gather_tables(const Family& family, const Particles& particles);

  CorrectionKind kind_;
  VectorArray stretch_, dilatation_;
  ScalarArray volume_, own_family_;
  std::vector<std::vector<BondFactors>> tables_;
  std::vector<std::int32_t> table_of_;
};

/// n_p²/2 of a bond, rounded so that the sum over p of (1 + 1) n_p²/2, in order with fused multiply-adds, is exactly 1.
Vec3d interpolation_weights(const Vec3d& direction);

}  // namespace perimpact
