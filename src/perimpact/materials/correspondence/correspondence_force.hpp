/// Forces of a correspondence material: a first pass over all bonds for the gradients of the particles, which breaks what breaks, and a last one
/// for the forces. With the stabilisation bond-level two lie between: one for F¹ and its stress, and one, its transpose, that takes this stress back to
/// the gradients F of which F¹ is made.
///
/// K⁻¹, χ and the spring bound change only where bonds go. They are kept, together with the bonds that they are of; a pass that finds other bonds makes them
/// anew, whoever took them away: this pass, a crack, or a checkpoint that was read. So they are no part of the state.
#pragma once

#include <cstdint>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/correspondence/correspondence.hpp"

namespace perimpact {

template <std::size_t D>
class CorrespondenceForce {
 public:
  static constexpr std::size_t symmetric = D * (D + 1) / 2, loads = D * D + 1;

  /// D: 2 of plane particles, else 3.
  CorrespondenceForce(const Correspondence& law, Breaking breaking, Family& family, const Particles& particles);

  /// Writes particles.force_density and the sums of the rows.
  template <class Pack>
  void pass(Particles& particles, Family& family, const PassOptions& options, RowSums& rows);

  const Breaking& breaking() const { return breaking_; }
  const Correspondence& law() const { return law_; }
  /// K⁻¹ [1/m⁵] as of construction or the last pass; 0 where the family has no gradient.
  SmallMatrix<double, D> inverse_shape(std::size_t slot) const;
  /// χ [-]: what damage leaves of the particle's stress, as of construction or the last pass; 0 where it has no gradient.
  double remaining(std::size_t slot) const { return shape_.component(symmetric)[slot]; }
  /// [N/m⁷] of the springs, pulling in all directions, that are stiffer than the bond (Correspondence::spring_bound); as of construction or the last pass.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const {
    const double* bound = shape_.component(symmetric + 1);
    return law_.weight(bond.length) * (bound[slot] + bound[bond.j]);
  }
  double bytes() const;  ///< [bytes] of memory

 private:
  template <class Pack, class View>
  void bond_level_pass(const View& body, Particles& particles, Family& family, const PassOptions& options, RowSums& rows);
  /// What breaking took of the elastic energy, where some of a particle's bonds broke in the pass; makes K⁻¹, χ and F of such particles anew.
  template <class Pack, class View>
  void account_for_broken(const View& body, const Particles& particles, double dt, RowSums& rows);
  template <class Visit>
  void with_bonds(const Particles& particles, Family& family, const Visit& visit);

  Correspondence law_;
  Breaking breaking_;
  std::vector<std::uint8_t> known_;     // the bonds that K⁻¹ is of
  SlotArray<symmetric + 2> shape_;      // [1/m⁵] K⁻¹: its upper triangle by rows; then χ; then χ times the spring bound [N/m⁷]
  std::vector<double> bound_at_first_;  // [N/m⁷] spring bound of each particle
  SlotArray<loads> response_;           // [N/m⁷] B by rows, then c

  // of the stabilisation bond-level
  SlotArray<D * D> gradient_;         // [-] F by rows
  SlotArray<D * D> carried_;          // [Pa/m⁵] Q = χ P K⁻¹, the stress that goes back to the gradients of neighbours
  SlotArray<D * D> rate_;             // [1/s] dF/dt, of particles near broken bonds; where bonds may break
  std::vector<std::uint8_t> broken_;  // of each eight slots: how near they are to bonds that broke in this pass

  // of each bond of the stencil
  std::vector<Vec3d> bonds_;             // [m] ξ
  std::vector<double> weighted_volume_;  // [m³] ω v V

  // of a list
  VectorArray reference_;                                // [m] X
  fccda::AlignedVector<double> listed_weighted_volume_;  // [m³] ω v V of each entry
};

}  // namespace perimpact
