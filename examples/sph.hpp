// Weakly compressible SPH (Monaghan, Simulating free surface flows with SPH, J. Comput. Phys. 110 (1994) 399): cubic spline kernel, Tait's
// equation of state, artificial viscosity, symplectic Euler.
//
//   dρ_i/dt = Σ m (v_i - v_j)·∇W_ij
//   dv_i/dt = -Σ m (p_i/ρ_i² + p_j/ρ_j² + Π_ij) ∇W_ij + g
//   p = (ρ₀ c²/7) ((ρ/ρ₀)⁷ - 1), at least 0: no tension between drops
//   Π_ij = -α c μ/ρ̄,  μ = h (v_i - v_j)·r/(r² + 0.01 h²) for approaching particles
#pragma once

#include <algorithm>
#include <cmath>
#include <fccda/fccda.hpp>
#include <numbers>
#include <vector>

namespace sph {

using namespace fccda;

constexpr double rho_0 = 1000, alpha = 0.1;  // [kg/m³], [-]
constexpr double gravity = 9.81;             // [m/s²]
constexpr double sound = 45;                 // [m/s] ten times the largest speed of the water

struct Water {
  std::vector<Vec3d> x, v, a;
  std::vector<double> rho, rho_rate, pressure;
  double mass = 0, h = 0;  // [kg] of a particle, [m] smoothing length

  /// A block of water of that size [m] that falls, about the z axis and above z = `bottom`.
  Water(double spacing, const Vec3d& size, double bottom, double fall_speed) : mass(rho_0 * spacing * spacing * spacing), h(1.3 * spacing) {
    const auto count = [&](double length) { return static_cast<int>(std::lround(length / spacing)); };
    const int nx = count(size.x), ny = count(size.y), nz = count(size.z);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) x.push_back({spacing * (i - 0.5 * (nx - 1)), spacing * (j - 0.5 * (ny - 1)), bottom + spacing * (k + 1)});
    v.assign(x.size(), {0, 0, -fall_speed});
    rho.assign(x.size(), rho_0);
    a.resize(x.size()), rho_rate.resize(x.size()), pressure.resize(x.size());
  }

  double momentum_z() const {
    double sum = 0;
    for (const Vec3d& each : v) sum += mass * each.z;
    return sum;
  }

  void compute_rates();

  /// Moves by symplectic Euler; returns where the particles were.
  std::vector<Vec3d> advance(double dt) {
    compute_rates();
    std::vector<Vec3d> before = x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      v[i] += dt * a[i];
      rho[i] += dt * rho_rate[i];
      x[i] += dt * v[i];
    }
    return before;
  }

  /// Largest stable step [s], of the Courant number 0.3.
  double stable_step() const { return 0.3 * h / (sound + 5); }

 private:
  /// ∇W of the cubic spline, of support 2h in three dimensions, divided by r.
  double gradient_over_r(double r) const {
    const double q = r / h, norm = 1 / (std::numbers::pi * h * h * h * h);
    if (q < 1) return norm * (-3 * q + 2.25 * q * q) / r;
    return norm * -0.75 * (2 - q) * (2 - q) / r;
  }

  struct Cells {
    Vec3d low;
    double size;
    int nx, ny, nz;
    std::vector<int> first, next;  // per cell, per particle; -1 ends a list
    int along(double x, double low_x) const { return static_cast<int>((x - low_x) / size); }
    int number(int i, int j, int k) const { return (k * ny + j) * nx + i; }
  };
  Cells sorted() const;
};

inline Water::Cells Water::sorted() const {
  Box box;
  for (const Vec3d& each : x) box.include(each);
  Cells cells{box.low, 2 * h, 0, 0, 0, {}, std::vector<int>(x.size())};
  cells.nx = cells.along(box.high.x, box.low.x) + 1, cells.ny = cells.along(box.high.y, box.low.y) + 1, cells.nz = cells.along(box.high.z, box.low.z) + 1;
  cells.first.assign(std::size_t(cells.nx) * std::size_t(cells.ny) * std::size_t(cells.nz), -1);
  for (std::size_t i = x.size(); i-- > 0;) {
    const int cell = cells.number(cells.along(x[i].x, box.low.x), cells.along(x[i].y, box.low.y), cells.along(x[i].z, box.low.z));
    cells.next[i] = cells.first[std::size_t(cell)];
    cells.first[std::size_t(cell)] = static_cast<int>(i);
  }
  return cells;
}

inline void Water::compute_rates() {
  for (std::size_t i = 0; i < x.size(); ++i) pressure[i] = std::max(0.0, rho_0 * sound * sound / 7 * (std::pow(rho[i] / rho_0, 7) - 1));
  const Cells cells = sorted();
#pragma omp parallel for schedule(dynamic, 64)
  for (std::ptrdiff_t n = 0; n < static_cast<std::ptrdiff_t>(x.size()); ++n) {
    const auto i = static_cast<std::size_t>(n);
    Vec3d acceleration{0, 0, -gravity};
    double rate = 0;
    const int ci = cells.along(x[i].x, cells.low.x), cj = cells.along(x[i].y, cells.low.y), ck = cells.along(x[i].z, cells.low.z);
    for (int k = std::max(0, ck - 1); k <= std::min(cells.nz - 1, ck + 1); ++k)
      for (int j = std::max(0, cj - 1); j <= std::min(cells.ny - 1, cj + 1); ++j)
        for (int l = std::max(0, ci - 1); l <= std::min(cells.nx - 1, ci + 1); ++l)
          for (int other = cells.first[std::size_t(cells.number(l, j, k))]; other >= 0; other = cells.next[std::size_t(other)]) {
            const auto m = static_cast<std::size_t>(other);
            const Vec3d r = x[i] - x[m], w = v[i] - v[m];
            const double rr = squared_norm(r);
            if (m == i || rr >= 4 * h * h || rr == 0) continue;
            const double approach = dot(w, r), mean_rho = 0.5 * (rho[i] + rho[m]);
            const double viscosity = approach < 0 ? -alpha * sound * h * approach / ((rr + 0.01 * h * h) * mean_rho) : 0;
            const Vec3d gradient = gradient_over_r(std::sqrt(rr)) * r;
            rate += mass * dot(w, gradient);
            acceleration -= mass * (pressure[i] / (rho[i] * rho[i]) + pressure[m] / (rho[m] * rho[m]) + viscosity) * gradient;
          }
    a[i] = acceleration, rho_rate[i] = rate;
  }
}

}  // namespace sph
