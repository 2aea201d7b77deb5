/// Ordinary state-based peridynamics, linear and isotropic, in three dimensions. Bond-based is its case a = 0 (ν = 1/4).
///
///   force       f = [ 4 δ b s + 2 δ d a (θ_i + θ_j)/|ξ| ] n                     [N/m⁶]
///   dilatation  θ_i = d δ Σ s v V                                                [-]
///   energy      W_i = a θ_i² + b δ Σ s² |ξ| v V                                  [J/m³]
///   with        a = (κ - 5µ/3)/2,  b = 15µ/(2πδ⁵),  d = 9/(4πδ⁴),  s = (|η + ξ| - |ξ|)/|ξ|,  n = (η + ξ)/|η + ξ|
///
/// Madenci & Oterkus, Peridynamic Theory and Its Applications (2014), ch. 4; seed paper, eq. 3. Their Λ = n·ξ/|ξ| is taken as 1: with it
/// a turned fragment would lose its stiffness. On a lattice the sums are not the integrals; given the sums of the stencil, d is
/// scaled so that uniform strain has exactly its dilatation, and b so that a pull along a lattice axis meets exactly Young's modulus.
/// (Normalised on uniaxial strain instead, a bar along an axis of this lattice is 0.7 % too stiff; so, the lattice's modulus of plane
/// waves is 0.7 % too soft.)
///
/// The material sees one bond and one family sum. Where a surface correction is on, s v V carries the factors G (energy) and
/// G_θ (dilatation) of the bond.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "fccda/core/pack.hpp"
#include "perimpact/material/isotropic.hpp"

namespace perimpact {

/// What uniform strain sums to over the interior family of a lattice.
struct LatticeSums {
  double dilatation;  ///< [m³] Σ s v V for unit strain along a lattice axis
  double energy;      ///< [m⁴] Σ s² |ξ| v V for a pull along a lattice axis to unit strain, with the contraction ν across
};

class OrdinaryState {
 public:
  static constexpr std::string_view name = "ordinary-state";

  /// `horizon` δ [m]. With `lattice` the constants are normalised on the lattice, without it they are those of the continuum.
  OrdinaryState(const IsotropicElastic& elastic, double horizon, const std::optional<LatticeSums>& lattice) : horizon_(horizon) {
    const double mu = elastic.shear_modulus(), kappa = elastic.bulk_modulus();
    a_ = (kappa - 5 * mu / 3) / 2;
    if (std::fabs(a_) < 1e-12 * kappa) a_ = 0;  // ν = 1/4, but for rounding
    b_ = 15 * mu / (2 * std::numbers::pi * std::pow(horizon, 5));
    d_ = 9 / (4 * std::numbers::pi * std::pow(horizon, 4));
    if (lattice) {
      const double theta = 1 - 2 * elastic.poissons_ratio;  // of the pull
      d_ = 1 / (horizon * lattice->dilatation);
      b_ = (elastic.youngs_modulus / 2 - a_ * theta * theta) / (horizon * lattice->energy);
    }
  }

  bool needs_dilatation() const { return a_ != 0; }
  double a() const { return a_; }                              ///< [Pa]
  double b() const { return b_; }                              ///< [Pa/m⁵]
  double d() const { return d_; }                              ///< [1/m⁴]
  double bond_stiffness() const { return 4 * horizon_ * b_; }  ///< [N/m⁶] of a stretch: c of the bond-based theory

  /// The constants of one stencil bond, folded once for all particles.
  struct Folded {
    double spring;          ///< 4 δ b v V / |ξ|      [N/m⁴]
    double minus_rest;      ///< -4 δ b v V           [N/m³]
    double dilatation;      ///< 2 δ d a v V / |ξ|    [N/m³]
    double theta_slope;     ///< d δ v V / |ξ|        [1/m]
    double theta_rest;      ///< -d δ v V             [-]
    double inverse_length;  ///< 1/|ξ|                [1/m]
    double energy;          ///< b δ |ξ| v V          [J/m³]
  };
  Folded fold(double length, double volume) const {
    const double c = bond_stiffness() * volume, theta = d_ * horizon_ * volume;
    return {c / length, -c, 2 * a_ * theta / length, theta / length, -theta, 1 / length, b_ * horizon_ * length * volume};
  }

  /// d δ s v V of one bond of current length `length` [-].
  template <class Pack>
  static Pack dilatation(const Folded& bond, Pack length) {
    return fccda::fused(Pack(bond.theta_slope), length, Pack(bond.theta_rest));
  }
  /// f v V/|η + ξ| without the dilatation term [N/m⁴], from 1/|η + ξ|.
  template <class Pack>
  static Pack stretch_force(const Folded& bond, Pack inverse_length) {
    return fccda::fused(Pack(bond.minus_rest), inverse_length, Pack(bond.spring));
  }
  /// The dilatation term of the same, before the factor 1/|η + ξ| [N/m³].
  template <class Pack>
  static Pack dilatation_force(const Folded& bond, Pack theta_i, Pack theta_j) {
    return Pack(bond.dilatation) * (theta_i + theta_j);
  }
  /// b δ s² |ξ| v V [J/m³].
  template <class Pack>
  static Pack stretch_energy(const Folded& bond, Pack length) {
    const Pack stretch = fccda::fused(Pack(bond.inverse_length), length, Pack(-1.0));
    return Pack(bond.energy) * stretch * stretch;
  }
  /// a θ² [J/m³].
  template <class Pack>
  Pack dilatation_energy(Pack theta) const {
    return Pack(a_) * theta * theta;
  }

 private:
  double horizon_;  // [m]
  double a_, b_, d_;
};

}  // namespace perimpact
