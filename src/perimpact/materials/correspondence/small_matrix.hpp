/// Matrices of size 2 × 2 or 3 × 3, of doubles or packs, for deformation gradients and stresses. Loops have constant bounds and no branches, so
/// that kernels can call these functions for a pack of particles.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "base/host_device.hpp"
#include "base/pack.hpp"

namespace perimpact {

template <class T, std::size_t D>
struct SmallMatrix {
  T m[D][D]{};

  FCCDA_HD static SmallMatrix identity() {
    SmallMatrix one;
    for (std::size_t r = 0; r < D; ++r) one.m[r][r] = T(1.0);
    return one;
  }
};

template <class T, std::size_t D>
FCCDA_HD T trace(const SmallMatrix<T, D>& a) {
  T sum = a.m[0][0];
  for (std::size_t r = 1; r < D; ++r) sum = sum + a.m[r][r];
  return sum;
}

template <class T, std::size_t D>
FCCDA_HD SmallMatrix<T, D> transpose(const SmallMatrix<T, D>& a) {
  SmallMatrix<T, D> t;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) t.m[r][s] = a.m[s][r];
  return t;
}

template <class T, std::size_t D>
FCCDA_HD SmallMatrix<T, D> operator*(const SmallMatrix<T, D>& a, const SmallMatrix<T, D>& b) {
  SmallMatrix<T, D> product;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) {
      T sum = a.m[r][0] * b.m[0][s];
      for (std::size_t k = 1; k < D; ++k) sum = fccda::fused_multiply_add(a.m[r][k], b.m[k][s], sum);
      product.m[r][s] = sum;
    }
  return product;
}

/// f a + b
template <class T, std::size_t D>
FCCDA_HD SmallMatrix<T, D> scaled_sum(T f, const SmallMatrix<T, D>& a, const SmallMatrix<T, D>& b) {
  SmallMatrix<T, D> sum;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) sum.m[r][s] = fccda::fused_multiply_add(f, a.m[r][s], b.m[r][s]);
  return sum;
}

/// f a + g 1
template <class T, std::size_t D>
FCCDA_HD SmallMatrix<T, D> scaled_plus(T f, const SmallMatrix<T, D>& a, T g) {
  SmallMatrix<T, D> sum;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) sum.m[r][s] = r == s ? fccda::fused_multiply_add(f, a.m[r][s], g) : f * a.m[r][s];
  return sum;
}

/// Double contraction a : b = tr(a bᵀ).
template <class T, std::size_t D>
FCCDA_HD T contraction(const SmallMatrix<T, D>& a, const SmallMatrix<T, D>& b) {
  T sum = a.m[0][0] * b.m[0][0];
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s)
      if (r + s > 0) sum = fccda::fused_multiply_add(a.m[r][s], b.m[r][s], sum);
  return sum;
}

/// Adjugate a⁻¹ det a of a symmetric matrix; exists also for singular ones.
template <class T, std::size_t D>
FCCDA_HD SmallMatrix<T, D> adjugate(const SmallMatrix<T, D>& a) {
  SmallMatrix<T, D> adj;
  if constexpr (D == 2) {
    adj.m[0][0] = a.m[1][1], adj.m[1][1] = a.m[0][0];
    adj.m[0][1] = adj.m[1][0] = T(-1.0) * a.m[0][1];
  } else {
    const auto minor_of = [&](std::size_t r, std::size_t s) {
      const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, s1 = (s + 1) % 3, s2 = (s + 2) % 3;
      return fccda::fused_multiply_add(a.m[r1][s1], a.m[r2][s2], T(-1.0) * (a.m[r1][s2] * a.m[r2][s1]));
    };
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = r; s < 3; ++s) adj.m[r][s] = adj.m[s][r] = minor_of(r, s);
  }
  return adj;
}

/// Determinant of a symmetric matrix, given its adjugate.
template <class T, std::size_t D>
FCCDA_HD T determinant(const SmallMatrix<T, D>& a, const SmallMatrix<T, D>& adj) {
  T sum = a.m[0][0] * adj.m[0][0];
  for (std::size_t k = 1; k < D; ++k) sum = fccda::fused_multiply_add(a.m[0][k], adj.m[0][k], sum);
  return sum;
}

template <std::size_t D>
struct Eigen {
  double value[D];
  SmallMatrix<double, D> vectors;  ///< as columns
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi rotations (Golub and Van Loan, Matrix Computations, 8.5); each value
/// accurate to rounding of the largest.
template <std::size_t D>
FCCDA_HD Eigen<D> eigen_of(SmallMatrix<double, D> a) {
  SmallMatrix<double, D> q = SmallMatrix<double, D>::identity();
  constexpr int most_sweeps = 20;  // convergence is quadratic: five suffice
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double off = 0;
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = r + 1; s < D; ++s) off += std::fabs(a.m[r][s]);
    if (!(off > 0)) break;
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = r + 1; s < D; ++s) {
        if (a.m[r][s] == 0) continue;
        const double tau = (a.m[s][s] - a.m[r][r]) / (2 * a.m[r][s]);
        const double t = (tau >= 0 ? 1 : -1) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
        const double c = 1 / std::sqrt(1 + t * t), sine = t * c;
        for (std::size_t k = 0; k < D; ++k) {
          const double kr = a.m[k][r], ks = a.m[k][s];
          a.m[k][r] = c * kr - sine * ks, a.m[k][s] = sine * kr + c * ks;
        }
        for (std::size_t k = 0; k < D; ++k) {
          const double rk = a.m[r][k], sk = a.m[s][k], qr = q.m[k][r], qs = q.m[k][s];
          a.m[r][k] = c * rk - sine * sk, a.m[s][k] = sine * rk + c * sk;
          q.m[k][r] = c * qr - sine * qs, q.m[k][s] = sine * qr + c * qs;
        }
        a.m[r][s] = a.m[s][r] = 0;
      }
  }
  Eigen<D> result{};
  for (std::size_t r = 0; r < D; ++r) result.value[r] = a.m[r][r];
  result.vectors = q;
  return result;
}

}  // namespace perimpact
