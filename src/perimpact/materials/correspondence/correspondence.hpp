/// Correspondence: the family of a particle gives it a deformation gradient, a classical law gives the stress of that, and the stress goes back
/// into the bonds (Silling et al., J. Elast. 88 (2007) 151, section 18). In space (D = 3) and in the plane (D = 2).
///
///   shape tensor      K = Σ ω ξ⊗ξ v V                                                 [m⁵]
///   gradient          F = [Σ ω y⊗ξ v V] K⁻¹,   y = x_j - x_i                          [-]
///   stress            P = F S(F)                           material/stress_law.hpp    [Pa]
///   residual          z = y - F ξ                                                     [m]
///   after damage      W_i χ_i, P_i χ_i, c_i χ_i,   χ = min(1, 2 k at first/k now)     spring_bound() is k
///
/// Residuals are penalised, because F does not see patterns in which the displacements of a family cancel out (zero-energy modes).
///
///   wan, silling: each bond against the gradients of its two ends
///
///     force           f = t_ij - t_ji,   t_ij = ω [ P_i K_i⁻¹ ξ + c_i z ]             [N/m⁶]
///     energy          W_i = ψ(F) + c_i/2 Σ ω |z|² v V                                 [J/m³]
///     wan             c = κ tr K⁻¹, the isotropic part of C1 = C : K⁻¹ (Wan et al., Acta Mech. Sin. 35 (2019) 1021), and equal to it in a whole
///                     family; a number, it turns with the body
///     silling         c = G C/δ · m₁/m, C = 18κ/(πδ⁴), in the plane 12κ/(πhδ³), G = 1/2 (Silling, Comput. Methods Appl. Mech. Eng. 322 (2017)
///                     42); m = ∫ ω |ξ|² dV, m₁ = ∫ |ξ|² dV: ω may be scaled and weighted as one likes
///
///   bond-level: each bond against the mean of the gradients of its ends, F̄ = (F_i + F_j)/2, which is exact where strain is uniform or grows linearly
///   (after Breitzman and Dayal, J. Mech. Phys. Solids 110 (2018) 192); the stress is that of F¹, the mean of their bond-level gradients
///
///     F¹_i = F_i + Σ χ_j ω (y - F̄ξ)⊗ξ v V K_i⁻¹ = F_i + T_i K_i⁻¹/2,   T_i = Σ χ_j ω (F_i - F_j) ξ⊗ξ v V
///     energy          W_i = ψ(F¹) + c_i/2 Σ ω |z|² v V - c_i/8 Σ χ_j ω |(F_i - F_j) ξ|² v V        with χ = 1: ψ(F¹) + c/2 Σ ω |y - F̄ξ|² v V
///     c               2D µ/m
///
/// Σ ω z⊗ξ v V = 0 by the choice of F, so that f is exactly the gradient of the energy, and this is the same in every
/// turned state: forces and moments of a body sum to zero (docs/theory/correspondence.md).
///
/// Without χ, the fewer and the flatter its bonds, the stiffer a particle would hold on to them, until the time step is too long.
#pragma once

#include <algorithm>
#include <numbers>

#include "perimpact/materials/correspondence/stress_law.hpp"
#include "perimpact/materials/elastic/influence.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

enum class Stabilisation { bond_level, wan, silling };

struct CorrespondenceOptions {
  StressLaw law = StressLaw::hencky;
  Stabilisation stabilisation = Stabilisation::bond_level;
  double stabilisation_factor = 1;  ///< [-] multiplies c
  Influence influence = Influence::inverse;
};

class Correspondence {
 public:
  /// `horizon` δ [m]; `thickness` [m] of a plane body (1 in space).
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
    uniform_ = options.stabilisation_factor * G * micromodulus / horizon * m(Influence::one) / m(options.influence);
  }

  const IsotropicElastic& elastic() const { return elastic_; }
  const CorrespondenceOptions& options() const { return options_; }
  bool is_bond_level() const { return options_.stabilisation == Stabilisation::bond_level; }
  double weight(double length) const { return weight_of(options_.influence, length, horizon_) / (length * length); }  ///< ω [-]

  /// Least det K/(tr K/D)^D of a family that has a gradient; 1 is a round family, 0 one that lies in a plane. Strains across a flatter family are
  /// noise, and χ has left little of its stress. Undamaged bodies have 0.19 or more, even at the end of a bar of 2 × 2 particles.
  static constexpr double least_roundness = 0.05;

  /// K⁻¹ [1/m⁵]; 0 where the family is not round enough to have a gradient.
  template <class T, std::size_t D>
  static SmallMatrix<T, D> inverse_shape(const SmallMatrix<T, D>& shape) {
    SmallMatrix<T, D> inverse = adjugate(shape);
    const T det = determinant(shape, inverse), mean = trace(shape) * T(1.0 / D);
    const T cube = D == 3 ? mean * mean * mean : mean * mean;
    const T factor = fccda::select(fccda::bits_where_greater(det, T(least_roundness) * cube), T(1.0) / det);
    for (auto& row : inverse.m)
      for (T& element : row) element = element * factor;
    return inverse;
  }

  /// What a particle does to its bonds: t = ω (through ξ + along y).
  template <class T, std::size_t D>
  struct Response {
    SmallMatrix<T, D> through;   ///< B = P K⁻¹ - c F [N/m⁷]
    T along;                     ///< c [N/m⁷]
    SmallMatrix<T, D> gradient;  ///< F [-]
    T energy;                    ///< ψ [J/m³]
  };

  /// F [-] of `moment` [m⁵], Σ ω y⊗ξ v V; 1 where there is no K⁻¹, `remaining` χ being 0.
  template <class T, std::size_t D>
  static SmallMatrix<T, D> gradient(const SmallMatrix<T, D>& moment, const SmallMatrix<T, D>& inverse, T remaining) {
    const unsigned has_gradient = fccda::bits_where_greater(remaining, T(0.0));
    const SmallMatrix<T, D> one = SmallMatrix<T, D>::identity();
    SmallMatrix<T, D> gradient = moment * inverse;
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) gradient.m[r][s] = fccda::select(has_gradient, gradient.m[r][s] - one.m[r][s]) + one.m[r][s];
    return gradient;
  }

  /// P [Pa] and ψ [J/m³].
  template <class T, std::size_t D>
  struct FirstStress {
    SmallMatrix<T, D> first;
    T energy;
  };
  template <class T, std::size_t D>
  FirstStress<T, D> stress(const SmallMatrix<T, D>& gradient) const {
    const SmallMatrix<T, D> displacement = scaled_sum(T(-1.0), SmallMatrix<T, D>::identity(), gradient), turned = transpose(displacement),
                            x = scaled_sum(T(1.0), turned * displacement, scaled_sum(T(1.0), turned, displacement));
    const double lambda = elastic_.lame_modulus(), mu = elastic_.shear_modulus();
    const Stress<T, D> stress = options_.law == StressLaw::hencky ? hencky_stress(x, lambda, mu) : st_venant_kirchhoff(x, lambda, mu);
    return {gradient * stress.second, stress.energy};
  }

  /// Of the stabilisations that compare each bond with the gradients of its ends.
  template <class T, std::size_t D>
  Response<T, D> respond(const SmallMatrix<T, D>& moment, const SmallMatrix<T, D>& inverse, T remaining) const {
    const SmallMatrix<T, D> gradient = this->gradient(moment, inverse, remaining);
    const FirstStress<T, D> stress = this->stress(gradient);
    const T c = remaining * stabilisation(trace(inverse));
    return {scaled_sum(T(-1.0) * c, gradient, stress.first * scaled_plus(remaining, inverse, T(0.0))), c, gradient, remaining * stress.energy};
  }

  /// c [N/m⁷] of a family with this tr K⁻¹.
  template <class T>
  T stabilisation(T trace_of_inverse) const {
    return fccda::fused_multiply_add(T(by_shape_), trace_of_inverse, T(uniform_));
  }

  /// k [N/m⁷], such that a particle resists small displacements less than springs of the stiffness ω k to all of its family would, which pull in
  /// all directions: W_i <= k/2 Σ ω |u_j - u_i|² v V. With g = ∇u, Σ ω |u_j - u_i|² v V = tr(g K gᵀ) + Σ ω |z|² v V, and
  /// (tr g)² <= tr(K⁻¹) tr(g K gᵀ), |sym g|² <= tr(g K gᵀ)/k_min.
  template <std::size_t D>
  double spring_bound(const SmallMatrix<double, D>& inverse) const {
    const Eigen<D> eigen = eigen_of(inverse);
    const double largest = *std::max_element(eigen.value, eigen.value + D), sum = trace(inverse);
    if (!(sum > 0)) return 0;
    return std::max(std::max(elastic_.lame_modulus(), 0.0) * sum + 2 * elastic_.shear_modulus() * largest, stabilisation(sum));
  }

  /// How much k may grow by damage before the stress fades: a crack through a round family leaves half of it and doubles k, and its faces keep
  /// their stiffness, as other surfaces do.
  static constexpr double max_growth = 2;

  /// χ, from the spring bounds of the family at first and now. So k χ is at most twice what it was at first, and a time step that is stable at first
  /// stays so (docs/theory/correspondence.md).
  static double remaining(double bound_at_first, double bound_now) { return bound_now > 0 ? std::min(1.0, max_growth * bound_at_first / bound_now) : 0; }

 private:
  IsotropicElastic elastic_;
  CorrespondenceOptions options_;
  double horizon_;       // [m]
  double by_shape_ = 0;  // [Pa] c/tr K⁻¹
  double uniform_ = 0;   // [N/m⁷]
};

}  // namespace perimpact
