/// Forces of an ordinary state-based material: one pass over all bonds, two with a dilatation term.
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/force/correction_kernels.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/ordinary_state/corrected_bond.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

/// Basis of the surface correction for this law.
CorrectionBasis basis_of(const OrdinaryState& law);

/// Force kernel of one body.
class OrdinaryStateForce {
 public:
  OrdinaryStateForce(OrdinaryState law, Breaking breaking, CorrectionFactors correction, const Family& family, const Particles& particles);

  /// Writes particles.force_density and the sums of the eights.
  template <class Pack>
  void pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums);

  /// f(view, corrections): what the passes over a body on a lattice read and write, with these bonds of `rows` rows (ordinary_state_kernels.hpp).
  template <class Bonds, class F>
  void with_view_of_lattice(Particles& particles, const Bonds& bonds, std::size_t rows, double dt, const F& f);

  /// Calls visit(span) for each array of this object that the view of a lattice refers to.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    visit(theta_.with_slack());
    visit(std::span(folded_)), visit(std::span(half_squares_));
    correction_.visit_arrays(visit);
    breaking_.visit_arrays(visit);
  }

  const Breaking& breaking() const { return breaking_; }
  const OrdinaryState& law() const { return law_; }
  const CorrectionFactors& correction() const { return correction_; }
  /// [N/m⁷] derivative of a bond's force density with respect to its length, without the dilatation term.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const { return corrected_stiffness(law_, correction_, slot, bond); }
  /// [1/m⁴] derivative of the sum θ of the particle with respect to a bond's length, per unit volume of the bond.
  double dilatation_slope(std::size_t slot, const FamilyBond& bond) const { return corrected_dilatation_slope(law_, correction_, slot, bond); }
  /// g_i [-] of the linear peridynamic solid, whose θ is g_i times that sum and enters the force with another factor g_i; else 1.
  double family_factor(std::size_t slot) const { return correction_.kind() == CorrectionKind::family ? 2 * correction_.own_family().component(0)[slot] : 1; }
  double bytes() const;           ///< [bytes] of memory
  StepMessages messages() const;  ///< of a pass

 private:
  Corrections<FamilyFactor, PlainBonds, true> corrections_by_family() const {
    const double* half = correction_.own_family().component(0);
    return {{half}, {}, half};
  }

  OrdinaryState law_;
  Breaking breaking_;
  CorrectionFactors correction_;
  ScalarArray theta_;  // [-] of each particle; empty without a dilatation term

  // of each bond of the stencil
  std::vector<OrdinaryState::Folded<double>> folded_;  // for each table of factors
  std::vector<Vec3d> half_squares_;

  // of each entry of the list [m⁵], with the factors of the surface correction
  fccda::AlignedVector<double> stretch_;     // ω_e |ξ|² v V
  fccda::AlignedVector<double> dilatation_;  // ω_θ |ξ|² v V; empty without a dilatation term
};

}  // namespace perimpact
