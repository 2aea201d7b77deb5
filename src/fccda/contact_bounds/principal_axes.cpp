#include "fccda/contact_bounds/principal_axes.hpp"

#include <cmath>
#include <tuple>
#include <utility>

namespace fccda {

namespace {

/// Eigenvectors of a symmetric matrix by Jacobi rotations, each of which zeroes one off-diagonal element. Golub and Van Loan, Matrix
/// Computations (2013), section 8.5.
std::array<Vec3d, 3> eigenvectors(std::array<std::array<double, 3>, 3> m) {
  std::array<Vec3d, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int sweeps = 12;  // convergence is quadratic: four or five suffice for doubles
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      if (m[p][q] == 0) continue;
      const double tau = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const double t = (tau >= 0 ? 1 : -1) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
      const double c = 1 / std::sqrt(1 + t * t), s = t * c;
      for (std::size_t k = 0; k < 3; ++k) std::tie(m[k][p], m[k][q]) = std::pair(c * m[k][p] - s * m[k][q], s * m[k][p] + c * m[k][q]);
      for (std::size_t k = 0; k < 3; ++k) std::tie(m[p][k], m[q][k]) = std::pair(c * m[p][k] - s * m[q][k], s * m[p][k] + c * m[q][k]);
      std::tie(v[p], v[q]) = std::pair(c * v[p] - s * v[q], s * v[p] + c * v[q]);
    }
  }
  return v;
}

Vec3d without_rounding(Vec3d axis) {
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::fabs(axis[k]) < 1e-9) axis[k] = 0;
    if (std::fabs(axis[k]) > std::fabs(axis[largest])) largest = k;
  }
  return normalised(axis[largest] < 0 ? -axis : axis);
}

}  // namespace

// A triangle of area A with corners a, b, c and s = a + b + c has ∫ x dA = A s/3 and ∫ x xᵀ dA = A (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/12.
AreaAxes area_axes(const Surface& surface) {
  const Vec3d middle = surface.report().bounds.centre();
  double area = 0;
  Vec3d first{};
  std::array<std::array<double, 3>, 3> second{};
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d a = surface.corner(t, 0) - middle, b = surface.corner(t, 1) - middle, c = surface.corner(t, 2) - middle, s = a + b + c;
    const double its = 0.5 * norm(cross(b - a, c - a));
    area += its;
    first += its / 3 * s;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) second[i][j] += its / 12 * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
  }
  const Vec3d centroid = first / area;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) second[i][j] -= area * centroid[i] * centroid[j];
  AreaAxes axes{.centroid = middle + centroid, .direction = eigenvectors(second)};
  for (Vec3d& direction : axes.direction) direction = without_rounding(direction);
  return axes;
}

}  // namespace fccda
