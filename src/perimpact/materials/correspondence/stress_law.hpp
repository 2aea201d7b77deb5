/// Isotropic hyperelastic laws at finite strain: the second Piola-Kirchhoff stress S and the energy ψ from X = C - 1 = Fᵀ F - 1.
/// C is invariant under rotations, so that rigid motions of any size are free of stress.
///
///   St Venant-Kirchhoff   E = X/2         S = λ tr(E) 1 + 2µ E                ψ = λ tr(E)²/2 + µ tr(E²)         [Pa], [J/m³]
///   Hencky                H = ln(C)/2     S = (λ tr(H) 1 + 2µ H) C⁻¹          ψ = λ tr(H)²/2 + µ tr(H²)
///
/// (Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis (2008), ch. 6; Hencky, Z. techn. Phys. 9 (1928) 215.)
/// S = 2 ∂ψ/∂C in both. In plane stress the third strain is a linear function of the other two, and the formulas apply in two
/// dimensions with the plane-stress λ (docs/theory/correspondence.md).
///
/// For strains below some 5 %, ln C is evaluated as a series for all particles of a pack at once: ln(1 + X) = 2 artanh Z, Z = X (2 + X)⁻¹. Larger
/// strains use the eigenvalues of each particle. Below a stretch of one tenth, ln c continues as its tangent: flattened or inverted families, as of
/// heavily damaged particles, then have a finite stress, the gradient of a finite energy.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/logarithm.hpp"
#include "perimpact/materials/correspondence/small_matrix.hpp"

namespace perimpact {

/// Second Piola-Kirchhoff stress S [Pa] and energy ψ [J/m³].
template <class T, std::size_t D>
struct Stress {
  SmallMatrix<T, D> second;
  T energy;
};

/// Isotropic elasticity in any strain measure: λ tr(E) 1 + 2µ E, and its energy.
template <class T, std::size_t D>
FCCDA_HD Stress<T, D> linear_stress(const SmallMatrix<T, D>& strain, double lambda, double mu) {
  const T volume = trace(strain);
  return {scaled_plus(T(2 * mu), strain, T(lambda) * volume), fccda::fused_multiply_add(T(0.5 * lambda) * volume, volume, T(mu) * contraction(strain, strain))};
}

template <class T, std::size_t D>
FCCDA_HD Stress<T, D> st_venant_kirchhoff(const SmallMatrix<T, D>& x, double lambda, double mu) {
  SmallMatrix<T, D> strain;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) strain.m[r][s] = T(0.5) * x.m[r][s];
  return linear_stress(strain, lambda, mu);
}

namespace hencky {

/// Largest Σ X_rs² for the series. The eigenvalues of X are then below 0.1, those of Z below 0.053, and the first neglected term, Z¹³/13, is
/// 4e-17 of Z.
inline constexpr double largest_square = 0.01;

/// Hencky law by the series.
template <class T, std::size_t D>
FCCDA_HD Stress<T, D> by_series(const SmallMatrix<T, D>& x, double lambda, double mu) {
  using Matrix = SmallMatrix<T, D>;
  const auto inverse = [](const Matrix& a) {
    Matrix adj = adjugate(a);
    const T one_over = T(1.0) / determinant(a, adj);
    for (auto& row : adj.m)
      for (T& element : row) element = element * one_over;
    return adj;
  };
  const Matrix z = x * inverse(scaled_plus(T(1.0), x, T(2.0))), z2 = z * z;
  Matrix sum = scaled_plus(T(1.0 / 11), z2, T(1.0 / 9));
  for (const double term : {1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0}) sum = scaled_plus(T(1.0), sum * z2, T(term));
  Stress<T, D> stress = linear_stress(sum * z, lambda, mu);  // artanh Z = ln(1 + X)/2 = H
  stress.second = stress.second * inverse(scaled_plus(T(1.0), x, T(1.0)));
  return stress;
}

/// Hencky law by eigenvalues, one particle at a time.
template <std::size_t D>
FCCDA_HD Stress<double, D> by_eigenvalues(const SmallMatrix<double, D>& x, double lambda, double mu) {
  constexpr double least = 0.01, log_of_least = -4.605170185988091;  // of C: a stretch of one tenth
  const Eigen<D> eigen = eigen_of(x);
  double strain[D], slope[D];  // h = ln(c)/2 and 2 dh/dc
  double volume = 0, squares = 0;
  for (std::size_t k = 0; k < D; ++k) {
    const double c = 1 + eigen.value[k];
    strain[k] = 0.5 * (c > least ? fccda::log_of_one_plus(eigen.value[k]) : log_of_least + (c - least) / least);
    slope[k] = 1 / fccda::larger(c, least);
    volume += strain[k];
    squares += strain[k] * strain[k];
  }
  Stress<double, D> stress{{}, 0.5 * lambda * volume * volume + mu * squares};
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s)
      for (std::size_t k = 0; k < D; ++k)
        stress.second.m[r][s] += (lambda * volume + 2 * mu * strain[k]) * slope[k] * eigen.vectors.m[r][k] * eigen.vectors.m[s][k];
  return stress;
}

}  // namespace hencky

template <class T, std::size_t D>
FCCDA_HD Stress<T, D> hencky_stress(const SmallMatrix<T, D>& x, double lambda, double mu) {
  constexpr std::size_t width = fccda::lanes<T>;
  Stress<T, D> stress = hencky::by_series(x, lambda, mu);
  const unsigned large = fccda::bits_where_greater(contraction(x, x), T(hencky::largest_square));
  if (large == 0) return stress;
  if constexpr (width == 1) {
    return hencky::by_eigenvalues(x, lambda, mu);
  } else {
    const auto spread = [](const T& pack, double(&out)[width]) { fccda::store(out, pack); };
    double values[width], energies[width], in[D][D][width], second[D][D][width];
    spread(stress.energy, energies);
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) spread(x.m[r][s], values), std::copy(values, values + width, in[r][s]), spread(stress.second.m[r][s], second[r][s]);
    for (std::size_t lane = 0; lane < width; ++lane) {
      if (!((large >> lane) & 1u)) continue;
      SmallMatrix<double, D> one;
      for (std::size_t r = 0; r < D; ++r)
        for (std::size_t s = 0; s < D; ++s) one.m[r][s] = in[r][s][lane];
      const Stress<double, D> exact = hencky::by_eigenvalues(one, lambda, mu);
      energies[lane] = exact.energy;
      for (std::size_t r = 0; r < D; ++r)
        for (std::size_t s = 0; s < D; ++s) second[r][s][lane] = exact.second.m[r][s];
    }
    stress.energy = fccda::load<T>(energies);
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) stress.second.m[r][s] = fccda::load<T>(second[r][s]);
    return stress;
  }
}

}  // namespace perimpact
