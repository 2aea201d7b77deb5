/// Ordinary state-based peridynamics, linear and isotropic, in space and in the plane: one law with two influence functions, of which
/// the known forms are cases.
///
///   dilatation  θ_i = (D/m_θ) Σ ω_θ |ξ| e v V                                               [-]
///   force       f = [ 4 b ω_e e + 2 a (D/m_θ) ω_θ |ξ| (θ_i + θ_j) ] n                       [N/m⁶]
///   energy      W_i = a θ_i² + b Σ ω_e e² v V                                               [J/m³]
///   with        e = |η + ξ| - |ξ|,  n = (η + ξ)/|η + ξ|,  m = ∫ ω |ξ|² dV,  D dimensions,
///               a = (κ - 5µ/3)/2,  b = 15µ/(2 m_e)  in space;   a = (κ - 2µ)/2,  b = 4µ/m_e  in the plane
///
/// Madenci and Oterkus: ω_θ = (δ/|ξ|)², ω_e = δ/|ξ| (Peridynamic Theory and Its Applications (2014), ch. 4; seed paper, eq. 3). Their
///   Λ = n·ξ/|ξ| is taken as 1: with it a turned fragment would lose its stiffness.
/// Linear peridynamic solid: ω_θ = ω_e, and each particle takes its own m_i = Σ ω |ξ|² v V in place of m (Silling et al., J. Elast. 88
///   (2007) 151); that is done by the factors of the body (family/surface_correction.hpp).
/// Bond-based: a = 0 with ω_e = δ/|ξ|, which is ν = 1/4 in space and in plane strain, 1/3 in plane stress.
///
/// On a lattice the sums are not the integrals. Given the sums of the stencil, D/m_θ becomes such that uniform strain has exactly its
/// dilatation, and b such that a pull along a lattice axis meets exactly Young's modulus. (Normalised on uniaxial strain instead, a
/// bar along an axis is 0.7 % too stiff; so, the lattice's modulus of plane waves is 0.7 % too soft.)
///
/// The law sees one bond and one family sum. Where a surface correction is on, v V carries the factors of the bond.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "base/pack.hpp"
#include "perimpact/materials/elastic/influence.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

/// What strain sums to over a whole family; every lattice axis gives the same.
struct FamilySums {
  double volume;      ///< [m³] Σ v V
  double weighted;    ///< [m⁵] Σ ω_θ |ξ|² v V
  double dilatation;  ///< [m⁵] Σ ω_θ |ξ| e v V for unit strain along one axis and none across
  double energy;      ///< [m⁵] Σ ω_e e² v V for a pull along one axis to unit strain, with the contraction ν across
};

/// How much a bond counts.
struct BondWeights {
  double dilatation;  ///< [m²] ω_θ |ξ|²
  double stretch;     ///< [m²] ω_e |ξ|²
};

struct Influences {
  Influence dilatation, stretch;
  BondWeights of(double length, double horizon) const { return {weight_of(dilatation, length, horizon), weight_of(stretch, length, horizon)}; }
};

inline constexpr Influences madenci_oterkus_influences{Influence::inverse_square, Influence::inverse};

class OrdinaryState {
 public:
  /// `horizon` δ [m]; `thickness` [m] of a plane body (1 in space). With `lattice` the constants are normalised on the lattice, without it
  /// they are those of the continuum.
  OrdinaryState(const IsotropicElastic& elastic, const Influences& influences, double horizon, double thickness, const std::optional<FamilySums>& lattice)
      : elastic_(elastic), influences_(influences), horizon_(horizon) {
    const double mu = elastic.shear_modulus(), kappa = elastic.bulk_modulus();
    const int dimension = elastic.dimension;
    a_ = (dimension == 3 ? kappa - 5 * mu / 3 : kappa - 2 * mu) / 2;
    if (std::fabs(a_) < 1e-12 * kappa) a_ = 0;  // bond-based, but for rounding
    const double m_e = weighted_volume(influences.stretch, horizon, dimension, thickness);
    b_ = (dimension == 3 ? 7.5 : 4) * mu / m_e;
    d_ = dimension / weighted_volume(influences.dilatation, horizon, dimension, thickness);
    constexpr double pi = std::numbers::pi;
    const double horizon_volume = dimension == 3 ? 4 * pi / 3 * horizon * horizon * horizon : pi * horizon * horizon * thickness;
    whole_ = lattice.value_or(FamilySums{horizon_volume, dimension / d_, 1 / d_, pull_energy() / b_});
    if (lattice) {
      d_ = 1 / lattice->dilatation;
      b_ = pull_energy() / lattice->energy;
    }
  }

  bool needs_dilatation() const { return a_ != 0; }
  double a() const { return a_; }  ///< [Pa]
  double b() const { return b_; }  ///< [Pa/m⁵]
  double d() const { return d_; }  ///< [1/m⁵] D/m_θ
  const IsotropicElastic& elastic() const { return elastic_; }
  BondWeights weights(double length) const { return influences_.of(length, horizon_); }
  /// [N/m⁷] what a bond's force density gains by each metre of its length: 4 b ω_e.
  double bond_stiffness(double length) const { return 4 * b_ * weights(length).stretch / (length * length); }

  /// The sums for which the constants are right: those of the lattice, or of the continuum.
  const FamilySums& whole_family() const { return whole_; }

  /// The constants of a bond, folded once for all particles (Number: double), or of a pack of bonds of a list.
  template <class Number>
  struct Folded {
    Number spring;          ///< 4 b ω_e v V              [N/m⁴]
    Number minus_rest;      ///< -4 b ω_e |ξ| v V         [N/m³]
    Number dilatation;      ///< 2 a d ω_θ |ξ| v V        [N/m³]
    Number theta_slope;     ///< d ω_θ |ξ| v V            [1/m]
    Number theta_rest;      ///< -d ω_θ |ξ|² v V          [-]
    Number inverse_length;  ///< 1/|ξ|                    [1/m]
    Number energy;          ///< b ω_e |ξ|² v V           [J/m³]
  };
  /// `stretch`, `dilatation` [m⁵]: ω_e |ξ|² v V and ω_θ |ξ|² v V.
  template <class Number>
  Folded<Number> fold(Number length, Number stretch, Number dilatation) const {
    const Number inverse = Number(1.0) / length;
    const Number c = Number(4 * b_) * stretch * inverse, theta = Number(d_) * dilatation;
    return {c * inverse, Number(-1.0) * c, Number(2 * a_) * theta * inverse, theta * inverse, Number(-1.0) * theta, inverse, Number(b_) * stretch};
  }

  /// What a bond of current length `length` adds to θ [-].
  template <class Pack, class Number>
  static Pack dilatation(const Folded<Number>& bond, Pack length) {
    return fccda::fused_multiply_add(Pack(bond.theta_slope), length, Pack(bond.theta_rest));
  }
  /// f v V/|η + ξ| without the dilatation term [N/m⁴], from 1/|η + ξ|.
  template <class Pack, class Number>
  static Pack stretch_force(const Folded<Number>& bond, Pack inverse_length) {
    return fccda::fused_multiply_add(Pack(bond.minus_rest), inverse_length, Pack(bond.spring));
  }
  /// The dilatation term of the same, before the factor 1/|η + ξ| [N/m³].
  template <class Pack, class Number>
  static Pack dilatation_force(const Folded<Number>& bond, Pack theta_i, Pack theta_j) {
    return Pack(bond.dilatation) * (theta_i + theta_j);
  }
  /// b ω_e e² v V [J/m³].
  template <class Pack, class Number>
  static Pack stretch_energy(const Folded<Number>& bond, Pack length) {
    const Pack stretch = fccda::fused_multiply_add(Pack(bond.inverse_length), length, Pack(-1.0));
    return Pack(bond.energy) * stretch * stretch;
  }
  /// a θ² [J/m³].
  template <class Pack>
  Pack dilatation_energy(Pack theta) const {
    return Pack(a_) * theta * theta;
  }

 private:
  /// [Pa] what the bonds hold of the energy of a pull to unit strain: E/2 - a θ², θ = 1 - (D - 1) ν.
  double pull_energy() const {
    const double theta = 1 - (elastic_.dimension - 1) * elastic_.poissons_ratio;
    return elastic_.youngs_modulus / 2 - a_ * theta * theta;
  }

  IsotropicElastic elastic_;
  Influences influences_;
  double horizon_;  // [m]
  FamilySums whole_;
  double a_, b_, d_;
};

}  // namespace perimpact
