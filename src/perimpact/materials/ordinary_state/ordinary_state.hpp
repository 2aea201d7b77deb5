/// Ordinary state-based peridynamics, linear and isotropic, in 3-D and 2-D: one law with two influence functions that includes the standard
/// models as special cases.
///
///   dilatation  θ_i = (D/m_θ) Σ ω_θ |ξ| e v V                                               [-]
///   force       f = [ 4 b ω_e e + 2 a (D/m_θ) ω_θ |ξ| (θ_i + θ_j) ] n                       [N/m⁶]
///   energy      W_i = a θ_i² + b Σ ω_e e² v V                                               [J/m³]
///   with        e = |η + ξ| - |ξ|,  n = (η + ξ)/|η + ξ|,  m = ∫ ω |ξ|² dV,  D dimensions,
///               a = (κ - 5µ/3)/2,  b = 15µ/(2 m_e)  in 3-D;   a = (κ - 2µ)/2,  b = 4µ/m_e  in 2-D
///
/// Madenci and Oterkus: ω_θ = (δ/|ξ|)², ω_e = δ/|ξ| (Peridynamic Theory and Its Applications (2014), ch. 4; Zhang et al., eq. 3). Their
///   Λ = n·ξ/|ξ| is set to 1: otherwise a rotated fragment would lose its stiffness.
/// Linear peridynamic solid: ω_θ = ω_e, and each particle has its own weighted volume m_i = Σ ω |ξ|² v V in place of m (Silling et al., J. Elast. 88
///   (2007) 151); through the correction factors of the body (family/surface_correction.hpp).
/// Bond-based: a = 0 with ω_e = δ/|ξ|, which implies ν = 1/4 in 3-D and plane strain, 1/3 in plane stress.
///
/// On a lattice the sums differ from the integrals. Given the sums of the stencil, D/m_θ is normalised such that uniform strain has exactly its
/// dilatation, and b such that uniaxial tension along a lattice axis has exactly Young's modulus. (The plane-wave modulus of the lattice is then
/// 0.7 % too soft; normalised on uniaxial strain instead, a bar along an axis would be 0.7 % too stiff.)
///
/// The law is that of one bond and one family sum. With a surface correction, v V includes the factors of the bond.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "perimpact/materials/elastic/influence.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

/// Family sums of uniform strain for a complete family; identical for all lattice axes.
struct FamilySums {
  double volume;      ///< [m³] Σ v V
  double weighted;    ///< [m⁵] Σ ω_θ |ξ|² v V
  double dilatation;  ///< [m⁵] Σ ω_θ |ξ| e v V for unit uniaxial strain along one axis
  double energy;      ///< [m⁵] Σ ω_e e² v V for uniaxial tension to unit strain along one axis, with lateral contraction ν
};

/// Weights of a bond.
struct BondWeights {
  double dilatation;  ///< [m²] ω_θ |ξ|²
  double stretch;     ///< [m²] ω_e |ξ|²
};

struct Influences {
  Influence dilatation, stretch;
  BondWeights of(double length, double horizon) const { return {weight_of(dilatation, length, horizon), weight_of(stretch, length, horizon)}; }
};

inline constexpr Influences madenci_oterkus_influences{Influence::inverse_square, Influence::inverse};

/// Constants and bond functions of the law.
class OrdinaryState {
 public:
  /// `horizon` δ [m]; `thickness` [m] of a 2-D body (1 in 3-D). With `lattice` the constants are normalised on the lattice;
  /// otherwise they are those of the continuum.
  OrdinaryState(const IsotropicElastic& elastic, const Influences& influences, double horizon, double thickness, const std::optional<FamilySums>& lattice)
      : elastic_(elastic), influences_(influences), horizon_(horizon) {
    const double mu = elastic.shear_modulus(), kappa = elastic.bulk_modulus();
    const int dimension = elastic.dimension;
    a_ = (dimension == 3 ? kappa - 5 * mu / 3 : kappa - 2 * mu) / 2;
    if (std::fabs(a_) < 1e-12 * kappa) a_ = 0;  // bond-based, to rounding
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
  /// [N/m⁷] derivative of a bond's force density with respect to its length: 4 b ω_e.
  double bond_stiffness(double length) const { return 4 * b_ * weights(length).stretch / (length * length); }

  /// The family sums on which the constants are normalised: of the lattice, or of the continuum.
  const FamilySums& whole_family() const { return whole_; }

  /// Precomputed constants of a bond, common to all particles (Number: double), or of a pack of bonds of a list.
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
  FCCDA_HD Folded<Number> fold(Number length, Number stretch, Number dilatation) const {
    const Number inverse = Number(1.0) / length;
    const Number c = Number(4 * b_) * stretch * inverse, theta = Number(d_) * dilatation;
    return {c * inverse, Number(-1.0) * c, Number(2 * a_) * theta * inverse, theta * inverse, Number(-1.0) * theta, inverse, Number(b_) * stretch};
  }

  /// Contribution to θ of a bond of current length `length` [-].
  template <class Pack, class Number>
  FCCDA_HD static Pack dilatation(const Folded<Number>& bond, Pack length) {
    return fccda::fused_multiply_add(Pack(bond.theta_slope), length, Pack(bond.theta_rest));
  }
  /// f v V/|η + ξ| without the dilatation term [N/m⁴], from 1/|η + ξ|.
  template <class Pack, class Number>
  FCCDA_HD static Pack stretch_force(const Folded<Number>& bond, Pack inverse_length) {
    return fccda::fused_multiply_add(Pack(bond.minus_rest), inverse_length, Pack(bond.spring));
  }
  /// The dilatation term of the same, before the factor 1/|η + ξ| [N/m³].
  template <class Pack, class Number>
  FCCDA_HD static Pack dilatation_force(const Folded<Number>& bond, Pack theta_i, Pack theta_j) {
    return Pack(bond.dilatation) * (theta_i + theta_j);
  }
  /// b ω_e e² v V [J/m³].
  template <class Pack, class Number>
  FCCDA_HD static Pack stretch_energy(const Folded<Number>& bond, Pack length) {
    const Pack stretch = fccda::fused_multiply_add(Pack(bond.inverse_length), length, Pack(-1.0));
    return Pack(bond.energy) * stretch * stretch;
  }
  /// a θ² [J/m³].
  template <class Pack>
  FCCDA_HD static Pack dilatation_energy(double a, Pack theta) {
    return Pack(a) * theta * theta;
  }

 private:
  /// [Pa] share of the bonds in the energy of uniaxial tension to unit strain: E/2 - a θ², θ = 1 - (D - 1) ν.
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
