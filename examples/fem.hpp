// Explicit finite elements: cubes of trilinear shape functions with eight Gauss points, lumped masses, large deformation.
//
// Material: neo-Hooke with ν = 0, first Piola-Kirchhoff stress P = µ (F - F⁻ᵀ), Young's modulus E = 2µ, so that slow bars follow the
// one-dimensional wave equation exactly; c = √(E/ρ).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fccda/fccda.hpp>
#include <vector>

namespace fem {

using namespace fccda;

constexpr double length = 0.2, width = 0.02;  // [m]
constexpr double rho = 1000, youngs = 10e6;   // [kg/m³], [Pa] like rubber
constexpr double shear = youngs / 2;          // [Pa]

inline Mat3 operator-(const Mat3& a, const Mat3& b) { return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}}; }

/// Inverse transpose from cofactors, and determinant.
struct Inverse {
  Mat3 transposed;
  double determinant;
  explicit Inverse(const Mat3& f) {
    const Vec3d a = cross(f.row[1], f.row[2]), b = cross(f.row[2], f.row[0]), c = cross(f.row[0], f.row[1]);
    determinant = dot(f.row[0], a);
    transposed = {{a / determinant, b / determinant, c / determinant}};
  }
};

/// An upright bar of equal cubes, its lower end at z = `bottom` [m]; it falls.
struct Bar {
  double cell;                       // [m]
  std::vector<Vec3d> x, v, force;    // of the nodes [m], [m/s], [N]
  std::vector<double> mass, stress;  // [kg], [Pa] axial stress, mean of the adjacent cells
  std::vector<std::array<std::size_t, 8>> cells;
  std::array<std::array<Vec3d, 8>, 8> slope;  // ∂N_a/∂X at Gauss point g [1/m]: equal in all cells
  double elastic_energy = 0;                  // [J]

  Bar(int along, double speed, double bottom) : cell(length / along) {
    const int n = std::max(1, static_cast<int>(std::lround(width / cell)));
    const auto node = [&](int i, int j, int k) { return std::size_t((k * (n + 1) + j) * (n + 1) + i); };
    for (int k = 0; k <= along; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) x.push_back({cell * (i - 0.5 * n), cell * (j - 0.5 * n), cell * k + bottom});
    for (int k = 0; k < along; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          cells.push_back({node(i, j, k), node(i + 1, j, k), node(i, j + 1, k), node(i + 1, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
                           node(i, j + 1, k + 1), node(i + 1, j + 1, k + 1)});
    v.assign(x.size(), {0, 0, -speed});
    force.resize(x.size()), stress.resize(x.size()), mass.resize(x.size());
    for (const auto& each : cells)
      for (const std::size_t a : each) mass[a] += rho * cell * cell * cell / 8;

    const double gauss = 1 / std::sqrt(3.0);
    for (unsigned g = 0; g < 8; ++g)
      for (unsigned a = 0; a < 8; ++a) {
        const auto sign = [](unsigned of, unsigned axis) { return of >> axis & 1u ? 1.0 : -1.0; };
        for (unsigned axis = 0; axis < 3; ++axis) {
          double product = sign(a, axis) / 4 / cell;
          for (unsigned other = 0; other < 3; ++other)
            if (other != axis) product *= 1 + sign(a, other) * sign(g, other) * gauss;
          slope[g][a][axis] = product;
        }
      }
  }

  double section() const { return width * width; }
  double momentum() const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += mass[i] * v[i].z;
    return sum;
  }
  double kinetic_energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * mass[i] * squared_norm(v[i]);
    return sum;
  }

  void compute_forces() {
    std::ranges::fill(force, Vec3d{});
    std::ranges::fill(stress, 0.0);
    elastic_energy = 0;
    const double weight = cell * cell * cell / 8;  // weight of a Gauss point [m³]
    for (const auto& each : cells)
      for (const auto& gradients : slope) {
        Mat3 f;  // deformation gradient
        for (std::size_t a = 0; a < 8; ++a)
          for (std::size_t axis = 0; axis < 3; ++axis) f.row[axis] += x[each[a]][axis] * gradients[a];
        const Inverse inverse(f);
        if (!(inverse.determinant > 0)) throw RunError("finite elements: a cell is inverted; use more cells.");
        const Mat3 p = f - inverse.transposed;  // stress divided by µ
        double squares = -3;
        for (const Vec3d& row : f.row) squares += squared_norm(row);
        elastic_energy += weight * shear * (0.5 * squares - std::log(inverse.determinant));
        for (std::size_t a = 0; a < 8; ++a) {
          force[each[a]] -= weight * shear * (p * gradients[a]);
          stress[each[a]] += shear * p.row[2].z * weight * rho / 8 / mass[each[a]];
        }
      }
  }
};

/// A step of symplectic Euler under the forces that compute_forces() found.
inline void advance(Bar& bar, double dt) {
  for (std::size_t i = 0; i < bar.x.size(); ++i) {
    bar.v[i] += dt / bar.mass[i] * bar.force[i];
    bar.x[i] += dt * bar.v[i];
  }
}

}  // namespace fem
