// A block of water falls on a hull and splashes:  sph_splash [spacing of the particles in metres] [frames]
//
// Weakly compressible SPH (Monaghan, Simulating free surface flows with SPH, J. Comput. Phys. 110 (1994) 399): cubic spline kernel, Tait's
// equation of state, artificial viscosity, symplectic Euler. The hull acts through fccda only: there are no wall particles.
// Frames for ParaView: splash_000.vtk and so on, and splash_hull.vtk.
//
//   dρ_i/dt = Σ m (v_i - v_j)·∇W_ij
//   dv_i/dt = -Σ m (p_i/ρ_i² + p_j/ρ_j² + Π_ij) ∇W_ij + g
//   p = (ρ₀ c²/7) ((ρ/ρ₀)⁷ - 1), at least 0: no tension between drops
//   Π_ij = -α c μ/ρ̄,  μ = h (v_i - v_j)·r/(r² + 0.01 h²) for approaching particles
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fccda/fccda.hpp>
#include <numbers>
#include <vector>

#include "vtk.hpp"

using namespace fccda;

namespace {

constexpr double rho_0 = 1000, alpha = 0.1;           // [kg/m³], [-]
constexpr double gravity = 9.81, fall_speed = 3;      // [m/s²], [m/s] initially
constexpr double sound = 45;                          // [m/s] ten times the largest speed of the water
constexpr double end_time = 0.25;                     // [s]
constexpr double half_length = 0.6, parallel = 0.25;  // [m] half-lengths of the hull and of its parallel middle body
constexpr double half_beam = 0.25, depth = 0.25;      // [m]

/// Keel up (0 0 depth), deck down at z = 0, pointed at both ends.
Panels hull_panels() {
  Panels hull;
  hull.vertices = {{-half_length, 0, 0},      {-parallel, half_beam, 0},  {parallel, half_beam, 0}, {half_length, 0, 0},
                   {parallel, -half_beam, 0}, {-parallel, -half_beam, 0}, {-parallel, 0, depth},    {parallel, 0, depth}};
  hull.add_quad(1, 2, 7, 6), hull.add_quad(4, 5, 6, 7);                                                            // sides
  hull.add_triangle(0, 1, 6), hull.add_triangle(0, 6, 5), hull.add_triangle(3, 7, 2), hull.add_triangle(3, 4, 7);  // ends
  hull.add_quad(1, 5, 4, 2), hull.add_triangle(0, 5, 1), hull.add_triangle(3, 2, 4);                               // deck
  return hull;
}

/// Inside test by the face planes of the convex hull, independent of fccda.
bool is_in_hull(const Vec3d& x) {
  const double side = std::fabs(x.y) / half_beam + x.z / depth;
  return x.z > 0 && side < 1 && std::fabs(x.x) / half_length + (1 - parallel / half_length) * side < 1;
}

struct Water {
  std::vector<Vec3d> x, v, a;
  std::vector<double> rho, rho_rate, pressure;
  double mass = 0, h = 0;  // [kg] of a particle, [m] smoothing length

  explicit Water(double spacing) : mass(rho_0 * spacing * spacing * spacing), h(1.3 * spacing) {
    const auto count = [&](double length) { return static_cast<int>(std::lround(length / spacing)); };
    const int nx = count(0.6), ny = count(0.4), nz = count(0.3);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) x.push_back({spacing * (i - 0.5 * (nx - 1)), spacing * (j - 0.5 * (ny - 1)), depth + spacing * (k + 1)});
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

Water::Cells Water::sorted() const {
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

void Water::compute_rates() {
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

void write_frame(const Water& water, int frame) {
  std::vector<double> speed;
  for (const Vec3d& each : water.v) speed.push_back(norm(each));
  char path[32];
  std::snprintf(path, sizeof path, "splash_%03d.vtk", frame);
  write_vtk(path, water.x, {{"speed", speed}, {"pressure", water.pressure}});
}

}  // namespace

int main(int argc, char** argv) try {
  const double spacing = argc > 1 ? std::atof(argv[1]) : 0.025;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 10;
  if (!(spacing >= 0.005 && spacing <= 0.1) || frames < 1) throw InputError("sph_splash: give a spacing between 0.005 and 0.1 m, then a number of frames.");

  Water water(spacing);
  ContactDetector detector{Surface(hull_panels()), {.radius = spacing / 2}};
  RigidBody hull({.mass = 1}, Pose(), {}, {}, {});  // fixed
  write_vtk("splash_hull.vtk", hull_panels());

  const int per_frame = static_cast<int>(std::ceil(end_time * (sound + 5) / (0.3 * water.h) / frames));  // Courant number 0.3
  const int steps = frames * per_frame;
  const double dt = end_time / steps;
  const double momentum_before = water.momentum_z(), weight = gravity * water.mass * double(water.x.size());
  double impulse = 0, largest_force = 0, largest_error = 0;
  std::size_t contacts_found = 0, ever_inside = 0;
  std::vector<Vec3d> before;
  for (int step = 0; step < steps; ++step) {
    if (step % per_frame == 0) write_frame(water, step / per_frame);
    water.compute_rates();
    before = water.x;
    for (std::size_t i = 0; i < water.x.size(); ++i) {
      water.v[i] += dt * water.a[i];
      water.rho[i] += dt * water.rho_rate[i];
      water.x[i] += dt * water.v[i];
    }
    const Motion motion = hull.advance(dt);
    const std::vector<Contact> contacts = detector.detect(motion, before, water.x);
    const ContactSum sum = respond(contacts, motion, hull, {.x_t0 = before, .x_t1 = water.x, .velocity = water.v, .mass = water.mass});

    contacts_found += contacts.size();
    impulse += sum.impulse.z;
    largest_force = std::max(largest_force, -sum.impulse.z / dt);
    largest_error = std::max(largest_error, std::fabs(water.momentum_z() + impulse - momentum_before + weight * dt * (step + 1)));
    ever_inside += static_cast<std::size_t>(std::ranges::count_if(water.x, is_in_hull));
  }
  write_frame(water, frames);

  std::printf("%zu particles, %d steps, %zu contacts; queries of the hull: %.1f particles per step\n", water.x.size(), steps, contacts_found,
              double(detector.swept().effort().points_tested) / steps);
  std::printf("particles ever inside the hull: %zu\n", ever_inside);
  std::printf("vertical impulse on the hull: %.4f N s; largest force %.0f N, the water weighs %.0f N\n", impulse, largest_force, weight);
  std::printf("momentum of the water + impulse on the hull - impulse of gravity: %.1e of the momentum at most\n", largest_error / std::fabs(momentum_before));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
