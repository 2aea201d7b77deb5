/// Forces of an ordinary state-based material: one pass over all bonds, two where it has a dilatation.
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

CorrectionBasis basis_of(const OrdinaryState& law);

class OrdinaryStateForce {
 public:
  OrdinaryStateForce(OrdinaryState law, Breaking breaking, CorrectionFactors correction, const Family& family, const Particles& particles);

  /// Writes particles.force_density and the sums of the rows.
  template <class Pack>
  void pass(Particles& particles, Family& family, const PassOptions& options, RowSums& rows);

  const Breaking& breaking() const { return breaking_; }
  const OrdinaryState& law() const { return law_; }
  const CorrectionFactors& correction() const { return correction_; }
  /// [N/m⁷] what the force density of a bond gains by each metre of its length, its dilatation left aside.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const {
    return law_.bond_stiffness(bond.length) * correction_.stretch_factor(slot, bond.j, interpolation_weights(bond.direction));
  }
  /// [1/m⁴] what each metre of a bond's length, and cubic metre of its volume, adds to the sum θ of the particle.
  double dilatation_slope(std::size_t slot, const FamilyBond& bond) const {
    return law_.d() * law_.weights(bond.length).dilatation / bond.length * correction_.dilatation_factor(slot, bond.j, interpolation_weights(bond.direction));
  }
  /// g_i [-] of the linear peridynamic solid, whose θ is g_i times that sum and pushes g_i times as hard; else 1.
  double family_factor(std::size_t slot) const { return correction_.kind() == CorrectionKind::family ? 2 * correction_.own_family().component(0)[slot] : 1; }
  double bytes() const;  ///< [bytes] of memory

 private:
  OrdinaryState law_;
  Breaking breaking_;
  CorrectionFactors correction_;
  ScalarArray theta_;  // [-] of each particle; empty where the material needs none

  // of each bond of the stencil
  std::vector<OrdinaryState::Folded<double>> folded_;  // for each table of factors
  std::vector<Vec3d> half_squares_;

  // of each entry of the list [m⁵], with the factors of the surface correction
  fccda::AlignedVector<double> stretch_;     // ω_e |ξ|² v V
  fccda::AlignedVector<double> dilatation_;  // ω_θ |ξ|² v V; empty where the material needs none
};

}  // namespace perimpact
