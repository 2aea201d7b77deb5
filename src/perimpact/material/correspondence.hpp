/// Correspondence: the family of a particle gives it a deformation gradient, a classical law gives the stress of that, and the stress goes back
/// into the bonds (Silling et al., J. Elast. 88 (2007) 151, section 18). In space (D = 3) and in the plane (D = 2).
///
///   shape             K = Σ ω ξ⊗ξ v V                                                 [m⁵]
///   gradient          F = [Σ ω y⊗ξ v V] K⁻¹,   y = x_j - x_i                          [-]
///   stress            P = F S(F)                           material/stress_law.hpp    [Pa]
///   what F leaves     z = y - F ξ                                                     [m]
///   force             f = t_ij - t_ji,   t_ij = ω [ P_i K_i⁻¹ ξ + c_i z ]             [N/m⁶]
///   energy            W_i = ψ(F) + c_i/2 Σ ω |z|² v V                                 [J/m³]
///   after damage      W_i χ_i, P_i χ_i, c_i χ_i,   χ = min(1, 2 k at first/k now)     spring_bound() is k
///
/// The last term of both resists what F does not see: patterns in which the displacements of a family cancel out (zero-energy modes).
///
///   Wan     c = κ tr K⁻¹, the isotropic part of C1 = C : K⁻¹ (Wan et al., Acta Mech. Sin. 35 (2019) 1021), and equal to it in a whole
///           family; a number, it turns with the body
///   Silling c = G C/δ · m₁/m, C = 18κ/(πδ⁴), in the plane 12κ/(πhδ³), G = 1/2 (Silling, Comput. Methods Appl. Mech. Eng. 322 (2017) 42);
///           m = ∫ ω |ξ|² dV, m₁ = ∫ |ξ|² dV: ω may be scaled and weighted as one likes
///
/// Σ ω z⊗ξ v V = 0 by the choice of F, so that f is exactly the gradient of the energy, and this, knowing only Fᵀ F and |z|, is the same in every
/// turned state: forces and moments of a body sum to zero (docs/theory/correspondence.md).
///
/// Without χ, the fewer and the flatter its bonds, the stiffer a particle would hold on to them, until the time step is too long.
#pragma once

#include <algorithm>
#include <numbers>

#include "perimpact/material/influence.hpp"
#include "perimpact/material/isotropic.hpp"
#include "perimpact/material/stress_law.hpp"

namespace perimpact {

enum class Stabilisation { wan, silling };

struct CorrespondenceOptions {
  StressLaw law = StressLaw::hencky;
  Stabilisation stabilisation = Stabilisation::wan;
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
    uniform_ = options.stabilisation_factor * G * micromodulus / horizon * m(Influence::one) / m(options.influence);
  }

  const IsotropicElastic& elastic() const { return elastic_; }
  const CorrespondenceOptions& options() const { return options_; }
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
    const T factor = fccda::keep_where(fccda::bits_where_greater(det, T(least_roundness) * cube), T(1.0) / det);
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

  /// `moment` [m⁵]: Σ ω y⊗ξ v V; `remaining`: χ, 0 where there is no K⁻¹.
  template <class T, std::size_t D>
  Response<T, D> respond(const SmallMatrix<T, D>& moment, const SmallMatrix<T, D>& inverse, T remaining) const {
    using Matrix = SmallMatrix<T, D>;
    const unsigned has_gradient = fccda::bits_where_greater(remaining, T(0.0));
    const Matrix one = Matrix::identity();
    Matrix gradient = moment * inverse, displacement;
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) {
        displacement.m[r][s] = fccda::keep_where(has_gradient, gradient.m[r][s] - one.m[r][s]);
        gradient.m[r][s] = displacement.m[r][s] + one.m[r][s];
      }
    const Matrix turned = transpose(displacement), x = scaled_sum(T(1.0), turned * displacement, scaled_sum(T(1.0), turned, displacement));
    const double lambda = elastic_.lame_modulus(), mu = elastic_.shear_modulus();
    const Stress<T, D> stress = options_.law == StressLaw::hencky ? hencky_stress(x, lambda, mu) : st_venant_kirchhoff(x, lambda, mu);
    const T c = remaining * stabilisation(trace(inverse));
    return {scaled_sum(T(-1.0) * c, gradient, gradient * stress.second * scaled_plus(remaining, inverse, T(0.0))), c, gradient, remaining * stress.energy};
  }

  /// c [N/m⁷] of a family with this tr K⁻¹.
  template <class T>
  T stabilisation(T trace_of_inverse) const {
    return fccda::fused(T(by_shape_), trace_of_inverse, T(uniform_));
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
  static constexpr double most_growth = 2;

  /// χ, from the spring bounds of the family at first and now. So k χ is at most twice what it was at first, and a time step that is stable at first
  /// stays so (docs/theory/correspondence.md).
  static double remaining(double bound_at_first, double bound_now) { return bound_now > 0 ? std::min(1.0, most_growth * bound_at_first / bound_now) : 0; }

 private:
  IsotropicElastic elastic_;
  CorrespondenceOptions options_;
  double horizon_;       // [m]
  double by_shape_ = 0;  // [Pa] c/tr K⁻¹
  double uniform_ = 0;   // [N/m⁷]
};

}  // namespace perimpact
