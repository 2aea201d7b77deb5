/// Particles near a surface miss bonds, so the body is too soft there. A correction multiplies each bond by a factor made from
/// numbers of its two particles; nothing is stored per bond of a lattice. Factors stay as they are when bonds break.
///
/// energy  (after Madenci and Oterkus 2014, ch. 4.2; default): a pull along each axis p, and a unit strain along it, give numbers
///         g_p = (what a whole family sums to)/(what this family sums to), once for the bonds' energy Σ ω_e e² v V and once for the
///         dilatation Σ ω_θ |ξ| e v V. A bond's factor is Σ_p n_p² (g_p(i) + g_p(j))/2: no root, no division in the kernel, where they take the
///         ellipsoid 1/√Σ_p (n_p/g_p)². Theirs is the smaller of the two means, and both leave thin bodies too stiff, because bonds between
///         a particle at the surface and one deeper inside count for both: a bar of 10 × 10 particles by 7 % (theirs 6 %). So the g_p of
///         all particles that have such bonds are then improved `sweeps` times by the ratio that is left: under 1 % on that bar after
///         four. More of them take from the bending stiffness (six layers: 0.92 of the classical without, 0.91 after four, 0.90 after
///         eight), and the factors begin to alternate from particle to particle.
///         In a cloud no family is whole, so all particles are corrected, and the factors also make up for its unevenness.
/// volume  (Le and Bobaru, Comput. Mech. 61 (2018) 499): 2 V₀/(V_i + V_j) with V = Σ v V, V₀ that of a whole family.
/// family  (linear peridynamic solid): every particle is normalised by its own weighted volume m_i; g_i = m/m_i multiplies its dilatation, and
///         (g_i + g_j)/2 its bonds.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "perimpact/family/family.hpp"

namespace perimpact {

enum class CorrectionKind { none, energy, volume, family };

/// What corrections know of the material.
struct CorrectionBasis {
  double poissons_ratio;                            ///< in the plane, that of the plane
  std::function<double(double)> dilatation_weight;  ///< [m²] ω_θ |ξ|² by length
  std::function<double(double)> stretch_weight;     ///< [m²] ω_e |ξ|² by length
  double volume, weighted, dilatation, energy;      ///< of a whole family: material/ordinary_state.hpp, FamilySums
};

/// The two factors of a bond [-].
struct BondFactors {
  double stretch = 1, dilatation = 1;
  bool operator==(const BondFactors&) const = default;
};

class CorrectionFactors {
 public:
  /// Factors of the body as cut out: holes are cut before, cracks after this.
  CorrectionFactors(CorrectionKind kind, const CorrectionBasis& basis, const Family& family, const Particles& particles);

  static constexpr int sweeps = 4;  ///< of the energy correction

  CorrectionKind kind() const { return kind_; }
  const VectorArray& stretch() const { return stretch_; }        ///< g_p of the bonds' energy [-]
  const VectorArray& dilatation() const { return dilatation_; }  ///< g_p of the dilatation [-]
  const ScalarArray& volume() const { return volume_; }          ///< V/(2 V₀) [-]
  const ScalarArray& own_family() const { return own_family_; }  ///< g/2 [-]

  /// Tables of the factors of all bonds of a stencil. The first is of whole families: all 1. In the middle of a row of a box, eight neighbours have
  /// the same factors bond by bond, and so have those of the next rows: a table then takes the place of the numbers of particles.
  const std::vector<std::vector<BondFactors>>& tables() const { return tables_; }
  static constexpr std::int32_t no_table = -1;
  /// The table of slots 8·eight … 8·eight + 7, or no_table where their factors differ, or too few others share them.
  std::int32_t table_of(std::size_t eight) const { return table_of_[eight]; }

  /// The factors of one bond, as the kernel computes them. `weights`: interpolation_weights of its direction.
  double stretch_factor(std::size_t i, std::size_t j, const Vec3d& weights) const;
  double dilatation_factor(std::size_t i, std::size_t j, const Vec3d& weights) const;  ///< of energy and volume; else 1

  double bytes() const;  ///< [bytes] of memory

 private:
  void balance_energy(const CorrectionBasis& basis, const Family& family, const Particles& particles, const std::vector<std::uint8_t>& changed);
  void weigh_volume(const CorrectionBasis& basis, const Family& family, const Particles& particles);
  void weigh_own_family(const CorrectionBasis& basis, const Family& family, const Particles& particles);

  void gather_tables(const Family& family);

  CorrectionKind kind_;
  VectorArray stretch_, dilatation_;
  ScalarArray volume_, own_family_;
  std::vector<std::vector<BondFactors>> tables_;
  std::vector<std::int32_t> table_of_;
};

/// n_p²/2 of a bond, rounded so that the sum over p of (1 + 1) n_p²/2, taken in order with fused multiply-adds, is exactly 1.
Vec3d interpolation_weights(const Vec3d& direction);

}  // namespace perimpact
