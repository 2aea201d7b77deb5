/// Non-ordinary state-based peridynamics, correspondence model: the family of a particle gives its deformation gradient, a classical law the
/// stress, and the stress the force states of the bonds (Silling et al., J. Elast. 88 (2007) 151, section 18). 3-D (D = 3) and 2-D (D = 2).
///
///   shape tensor      K = Σ ω ξ⊗ξ v V                                                 [m⁵]
///   gradient          F = [Σ ω y⊗ξ v V] K⁻¹,   y = x_j - x_i                          [-]
///   stress            P = F S(F)                           stress_law.hpp             [Pa]
///   residual          z = y - F ξ                                                     [m]
///   after damage      W_i χ_i, P_i χ_i, c_i χ_i,   χ = min(1, 2 k₀/k)     k: spring_bound(), k₀ initially
///
/// Residuals are penalised, because F does not resolve displacement patterns that cancel out in a family (zero-energy modes).
///
///   wan, silling: residual of each bond with the gradients of its two ends
///
///     force           f = t_ij - t_ji,   t_ij = ω [ P_i K_i⁻¹ ξ + c_i z ]             [N/m⁶]
///     energy          W_i = ψ(F) + c_i/2 Σ ω |z|² v V                                 [J/m³]
///     wan             c = κ tr K⁻¹, the isotropic part of C1 = C : K⁻¹ (Wan et al., Acta Mech. Sin. 35 (2019) 1021), and equal to it in a
///                     complete family; as a scalar it is objective
///     silling         c = G C/δ · m₁/m, C = 18κ/(πδ⁴), in 2-D 12κ/(πhδ³), G = 1/2 (Silling, Comput. Methods Appl. Mech. Eng. 322 (2017)
///                     42); m = ∫ ω |ξ|² dV, m₁ = ∫ |ξ|² dV: any ω and scaling of it
///
///   bond-level: residual with the mean of the gradients of the ends, F̄ = (F_i + F_j)/2, which is exact for uniform and linearly varying strain
///   (after Breitzman and Dayal, J. Mech. Phys. Solids 110 (2018) 192); the stress is that of F¹, the mean of their bond-level gradients
///
///     F¹_i = F_i + Σ χ_j ω (y - F̄ξ)⊗ξ v V K_i⁻¹ = F_i + T_i K_i⁻¹/2,   T_i = Σ χ_j ω (F_i - F_j) ξ⊗ξ v V
///     energy          W_i = ψ(F¹) + c_i/2 Σ ω |z|² v V - c_i/8 Σ χ_j ω |(F_i - F_j) ξ|² v V        with χ = 1: ψ(F¹) + c/2 Σ ω |y - F̄ξ|² v V
///     c               2D µ/m
///
/// Σ ω z⊗ξ v V = 0 by the definition of F, so that f is exactly the gradient of the energy. The energy is objective: forces and moments of a
/// body sum to zero (docs/theory/correspondence.md).
///
/// Without χ, the stiffness of a particle would grow as its family loses bonds or becomes flat, until the time step is unstable.
#pragma once

#include <numbers>

#include "perimpact/materials/correspondence/setup.hpp"
#include "perimpact/materials/correspondence/stress_law.hpp"
#include "perimpact/materials/elastic/influence.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

struct CorrespondenceOptions {
  StressLaw law = StressLaw::hencky;
  Stabilisation stabilisation = Stabilisation::bond_level;
  double stabilisation_factor = 1;  ///< [-] multiplies c
  Influence influence = Influence::inverse;
};

/// Constitutive law and stabilisation of one material.
class Correspondence {
 public:
  /// `horizon` δ [m]; `thickness` [m] of a 2-D body (1 in 3-D).
  Correspondence(const IsotropicElastic& elastic, const CorrespondenceOptions& options, double horizon, double thickness)
      : elastic_(elastic), options_(options), horizon_(horizon) {
    constexpr double pi = std::numbers::pi, G = 0.5;
    const double kappa = elastic.bulk_modulus(), delta2 = horizon * horizon;
    if (options.stabilisation == Stabilisation::wan) {
      by_shape_ = options.stabilisation_factor * kappa;
      return;
    }
    const double micromodulus = elastic.dimension == 3 ? 18 * kappa / (pi * delta2 * delta2) : 12 * kappa / (pi * thickness * delta2 * horizon);
    const auto m = [&](Influence influence) { return weighted_volume(influence, horizon, elastic.dimension, thickness); };
    if (options.stabilisation == Stabilisation::bond_level) {
      uniform_ = options.stabilisation_factor * 2 * elastic.dimension * elastic.shear_modulus() / m(options.influence);
      return;
    }
    uniform_ = options.stabilisation_factor * G * micromodulus / horizon * m(Influence::constant) / m(options.influence);
  }

  const IsotropicElastic& elastic() const { return elastic_; }
  const CorrespondenceOptions& options() const { return options_; }
  bool is_bond_level() const { return options_.stabilisation == Stabilisation::bond_level; }
  double weight(double length) const { return weight_of(options_.influence, length, horizon_) / (length * length); }  ///< ω [-]

  /// Minimum det K/(tr K/D)^D of a family with a deformation gradient; 1: isotropic family, 0: coplanar. Across a flatter family strains are noise,
  /// and χ leaves little stress. Undamaged bodies have 0.19 or more, even at the end of a bar of 2 × 2 particles.
  static constexpr double least_roundness = 0.05;

  /// Inverse shape tensor K⁻¹ [1/m⁵]; 0 if the family is below least_roundness.
  template <class T, std::size_t D>
  FCCDA_HD static SmallMatrix<T, D> inverse_shape(const SmallMatrix<T, D>& shape) {
    SmallMatrix<T, D> inverse = adjugate(shape);
    const T det = determinant(shape, inverse), mean = trace(shape) * T(1.0 / D);
    const T cube = D == 3 ? mean * mean * mean : mean * mean;
    const T factor = fccda::select(fccda::bits_where_greater(det, T(least_roundness) * cube), T(1.0) / det);
    for (auto& row : inverse.m)
      for (T& element : row) element = element * factor;
    return inverse;
  }

  /// Force state of a particle: t = ω (through ξ + along y).
  template <class T, std::size_t D>
  struct Response {
    SmallMatrix<T, D> through;   ///< B = P K⁻¹ - c F [N/m⁷]
    T along;                     ///< c [N/m⁷]
    SmallMatrix<T, D> gradient;  ///< F [-]
    T energy;                    ///< ψ [J/m³]
  };

  /// Deformation gradient F [-] from `moment` [m⁵], Σ ω y⊗ξ v V; identity if there is no K⁻¹, where `remaining`, χ, is 0.
  template <class T, std::size_t D>
  FCCDA_HD static SmallMatrix<T, D> gradient(const SmallMatrix<T, D>& moment, const SmallMatrix<T, D>& inverse, T remaining) {
    const unsigned has_gradient = fccda::bits_where_greater(remaining, T(0.0));
    const SmallMatrix<T, D> one = SmallMatrix<T, D>::identity();
    SmallMatrix<T, D> gradient = moment * inverse;
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) gradient.m[r][s] = fccda::select(has_gradient, gradient.m[r][s] - one.m[r][s]) + one.m[r][s];
    return gradient;
  }

  /// First Piola-Kirchhoff stress P [Pa] and energy ψ [J/m³].
  template <class T, std::size_t D>
  struct FirstStress {
    SmallMatrix<T, D> first;
    T energy;
  };
  template <class T, std::size_t D>
  FCCDA_HD FirstStress<T, D> stress(const SmallMatrix<T, D>& gradient) const {
    const SmallMatrix<T, D> displacement = scaled_sum(T(-1.0), SmallMatrix<T, D>::identity(), gradient), turned = transpose(displacement),
                            x = scaled_sum(T(1.0), turned * displacement, scaled_sum(T(1.0), turned, displacement));
    const double lambda = elastic_.lame_modulus(), mu = elastic_.shear_modulus();
    const Stress<T, D> stress = options_.law == StressLaw::hencky ? hencky_stress(x, lambda, mu) : st_venant_kirchhoff(x, lambda, mu);
    return {gradient * stress.second, stress.energy};
  }

  /// Response for the stabilisations wan and silling.
  template <class T, std::size_t D>
  FCCDA_HD Response<T, D> respond(const SmallMatrix<T, D>& moment, const SmallMatrix<T, D>& inverse, T remaining) const {
    const SmallMatrix<T, D> gradient = this->gradient(moment, inverse, remaining);
    const FirstStress<T, D> stress = this->stress(gradient);
    const T c = remaining * stabilisation(trace(inverse));
    return {scaled_sum(T(-1.0) * c, gradient, stress.first * scaled_plus(remaining, inverse, T(0.0))), c, gradient, remaining * stress.energy};
  }

  /// Stabilisation constant c [N/m⁷] of a family with this tr K⁻¹.
  template <class T>
  FCCDA_HD T stabilisation(T trace_of_inverse) const {
    return fccda::fused_multiply_add(T(by_shape_), trace_of_inverse, T(uniform_));
  }

  /// Spring bound k [N/m⁷] for stability: a particle is less stiff under small displacements than isotropic springs of stiffness ω k to its whole
  /// family: W_i <= k/2 Σ ω |u_j - u_i|² v V. With g = ∇u, Σ ω |u_j - u_i|² v V = tr(g K gᵀ) + Σ ω |z|² v V, and
  /// (tr g)² <= tr(K⁻¹) tr(g K gᵀ), |sym g|² <= tr(g K gᵀ)/k_min.
  template <std::size_t D>
  FCCDA_HD double spring_bound(const SmallMatrix<double, D>& inverse) const {
    const Eigen<D> eigen = eigen_of(inverse);
    const double sum = trace(inverse);
    if (!(sum > 0)) return 0;
    double largest = eigen.value[0];
    for (std::size_t k = 1; k < D; ++k) largest = fccda::larger(largest, eigen.value[k]);
    return fccda::larger(fccda::larger(elastic_.lame_modulus(), 0.0) * sum + 2 * elastic_.shear_modulus() * largest, stabilisation(sum));
  }

  /// Growth of k by damage above which the stress fades: a crack through a complete family removes half of it and doubles k, and its faces keep
  /// their stiffness, like other surfaces.
  static constexpr double max_growth = 2;

  /// Remaining fraction of stress χ, from the initial and current spring bounds. Since k χ is at most twice its initial value, an initially stable time
  /// step stays stable (docs/theory/correspondence.md).
  FCCDA_HD static double remaining(double bound_at_first, double bound_now) {
    if (!(bound_now > 0)) return 0;
    const double share = max_growth * bound_at_first / bound_now;
    return share < 1 ? share : 1;
  }

 private:
  IsotropicElastic elastic_;
  CorrespondenceOptions options_;
  double horizon_;       // [m]
  double by_shape_ = 0;  // [Pa] c/tr K⁻¹
  double uniform_ = 0;   // [N/m⁷]
};

}  // namespace perimpact
