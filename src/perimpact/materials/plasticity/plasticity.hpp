/// Pressure-dependent plasticity of ice: an ellipse in pressure and J2, with associated flow (docs/theory/ice_plasticity.md).
///
///   yield function   f = J2 - (a0 + a1 p + a2 p²) <= 0,  p = -tr σ/3, checked where p > 0
///   flow             Δε^p = Δλ ∂f/∂σ = Δλ [dev σ + (a1 + 2 a2 p)/3 · 1]
///   failure strain   ε_f = ε0 + ((p/p₂ - N)/M)²,  p₂ the larger root of a0 + a1 p + a2 p²
///
/// Surfaces: Riska and Frederking (1987), Derradji-Aouat (2000) and Kierkegaard (1993), as fitted ellipses in MPa; failure strain after Liu, Amdahl and
/// Løset (Cold Reg. Sci. Technol. 2011), constants of Mokhtari et al. (2022). For another uniaxial strength σ_c, stresses are scaled by s = σ_c/4.43 MPa:
/// (a0 s², a1 s, a2).
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "base/contract.hpp"

namespace perimpact {

enum class YieldSurface { riska_frederking, derradji_aouat, kierkegaard, von_mises };

/// xx, yy, zz, xy, yz, xz of a symmetric tensor; those of a strain are components of the tensor (not engineering shears).
using SymmetricTensor = std::array<double, 6>;

/// a : b
inline double double_contraction(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// [Pa] p of a stress.
inline double pressure_of(const SymmetricTensor& stress) { return -(stress[0] + stress[1] + stress[2]) / 3; }

/// The deviator of a tensor.
inline SymmetricTensor deviator_of(const SymmetricTensor& tensor) {
  const double mean = (tensor[0] + tensor[1] + tensor[2]) / 3;
  return {tensor[0] - mean, tensor[1] - mean, tensor[2] - mean, tensor[3], tensor[4], tensor[5]};
}

/// [Pa²] J2 of a stress.
inline double second_invariant(const SymmetricTensor& stress) {
  const SymmetricTensor s = deviator_of(stress);
  return 0.5 * double_contraction(s, s);
}

/// √(2/3 ε:ε) [-] of an increment of plastic strain.
inline double equivalent_strain(const SymmetricTensor& strain) { return std::sqrt(2.0 / 3 * double_contraction(strain, strain)); }

/// a0 + a1 p + a2 p²; a0 > 0, a1 >= 0, a2 <= 0.
struct YieldEllipse {
  double a0;  ///< [Pa²]
  double a1;  ///< [Pa]
  double a2;  ///< [-]

  /// [Pa²] the largest J2 at a pressure [Pa].
  double limit(double pressure) const { return a0 + pressure * (a1 + pressure * a2); }
  double slope(double pressure) const { return a1 + 2 * a2 * pressure; }  ///< [Pa]
  double function(const SymmetricTensor& stress) const { return second_invariant(stress) - limit(pressure_of(stress)); }
  /// p₂ [Pa]: beyond it no stress is admissible; infinite for a cylinder.
  double largest_pressure() const {
    if (a2 == 0) return std::numeric_limits<double>::infinity();
    return (-a1 - std::sqrt(a1 * a1 - 4 * a2 * a0)) / (2 * a2);
  }
  /// [Pa] at which uniaxial compression yields: J2 = σ²/3, p = σ/3.
  double compressive_strength() const {
    const double a = 1.0 / 3 - a2 / 9, b = a1 / 3;
    return (b + std::sqrt(b * b + 4 * a * a0)) / (2 * a);
  }
  /// The same for stresses that are `scale` times as large.
  YieldEllipse scaled(double scale) const { return {a0 * scale * scale, a1 * scale, a2}; }

  /// The published fit; of von_mises, the cylinder of 1 Pa.
  static YieldEllipse published(YieldSurface surface) {
    constexpr double mega = 1e6;
    switch (surface) {
      case YieldSurface::riska_frederking:
        return {1.60 * mega * mega, 4.26 * mega, -0.62};
      case YieldSurface::derradji_aouat:
        return {22.93 * mega * mega, 2.06 * mega, -0.023};
      case YieldSurface::kierkegaard:
        return {2.588 * mega * mega, 8.63 * mega, -0.163};
      case YieldSurface::von_mises:
        break;
    }
    return {1.0 / 3, 0, 0};
  }
  /// The same scaled to a uniaxial compressive strength [Pa].
  static YieldEllipse of_strength(YieldSurface surface, double strength) {
    const YieldEllipse ellipse = published(surface);
    return ellipse.scaled(strength / ellipse.compressive_strength());
  }
};

/// ε_f(p).
struct FailureStrain {
  double least = 0.01;     ///< [-] ε0
  double width = 1;        ///< [-] M
  double pressure = 0.75;  ///< [-] N
  double at(double relative_pressure) const {
    const double away = (relative_pressure - pressure) / width;
    return least + away * away;
  }
};

/// c [-] of J2 <= c p² for ice without cohesion of an angle of internal friction [rad]: the cone of Drucker and Prager through the compressive meridian of
/// Mohr and Coulomb (D. C. Drucker, W. Prager, Q. Appl. Math. 10 (1952) 157), q/p = 6 sin φ/(3 - sin φ), J2 = q²/3.
inline double residual_of_friction_angle(double angle) {
  const double ratio = 6 * std::sin(angle) / (3 - std::sin(angle));
  return ratio * ratio / 3;
}

/// Elastic constants of a cubic lattice [Pa]; both shear moduli are equal in an isotropic body.
struct ReturnModuli {
  double bulk;         ///< (C11 + 2 C12)/3
  double axial_shear;  ///< (C11 - C12)/2, of differences of normal strains along the axes
  double plane_shear;  ///< C44
};

/// Δε^p that brings a stress with f > 0 and p > 0 back to the surface, by the cutting-plane algorithm of Simo and Ortiz (Comput. Methods Appl. Mech. Eng. 49
/// (1985) 221). `stress` becomes that on the surface, f <= 1e-10 of the largest J2 there.
inline SymmetricTensor return_to_surface(const YieldEllipse& ellipse, const ReturnModuli& moduli, SymmetricTensor& stress) {
  constexpr int max_iterations = 100;
  constexpr double tolerance = 1e-10;
  SymmetricTensor strain{};
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const double p = pressure_of(stress), slope = ellipse.slope(p);
    const SymmetricTensor s = deviator_of(stress);
    const double axial = s[0] * s[0] + s[1] * s[1] + s[2] * s[2], plane = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    const double f = 0.5 * axial + plane - ellipse.limit(p);
    if (f <= tolerance * (0.5 * axial + plane + ellipse.a0)) break;
    const double multiplier = f / (2 * moduli.axial_shear * axial + 4 * moduli.plane_shear * plane + moduli.bulk * slope * slope);
    for (std::size_t c = 0; c < 6; ++c) {
      const double mean = c < 3 ? slope / 3 : 0, shear = c < 3 ? moduli.axial_shear : moduli.plane_shear;
      strain[c] += multiplier * (s[c] + mean);
      stress[c] -= multiplier * (2 * shear * s[c] + (c < 3 ? moduli.bulk * slope : 0));
    }
  }
  return strain;
}

/// The same for ice without cohesion, J2 <= `residual` p² and f <= 0: first isochoric flow to the cone, then associated flow to the ellipse. Crushed ice that
/// dilated as the normal of the cone requires would grow without end.
inline SymmetricTensor return_to_residual(const YieldEllipse& ellipse, double residual, const ReturnModuli& moduli, SymmetricTensor& stress) {
  SymmetricTensor strain{};
  const double p = pressure_of(stress), invariant = second_invariant(stress), limit = residual * p * p;
  if (invariant > limit) {
    const double excess = 1 - std::sqrt(limit / invariant);
    const SymmetricTensor s = deviator_of(stress);
    for (std::size_t c = 0; c < 6; ++c) {
      strain[c] = excess * s[c] / (2 * (c < 3 ? moduli.axial_shear : moduli.plane_shear));
      stress[c] -= excess * s[c];
    }
  }
  const SymmetricTensor of_ellipse = return_to_surface(ellipse, moduli, stress);
  for (std::size_t c = 0; c < 6; ++c) strain[c] += of_ellipse[c];
  return strain;
}

}  // namespace perimpact
