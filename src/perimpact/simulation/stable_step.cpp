#include "perimpact/simulation/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fccda/core/parallel.hpp"
#include "perimpact/simulation/stiffest_mode.hpp"

namespace perimpact {

namespace {

/// At which a damped oscillation of ω² [1/s²] and damping [1/s] begins to grow [s].
double longest_step(double squared, double damping) { return (std::sqrt(damping * damping + 4 * squared) - damping) / squared; }

}  // namespace

double silling_askari_step(const Body& body, const ShortRange::Bound& contact) {
  std::vector<double> stiffness(body.particles.size());
  fccda::parallel_for(static_cast<std::ptrdiff_t>(stiffness.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = body.particles.slot_of()[static_cast<std::size_t>(particle)];
    double sum = 0;
    body.family.for_each_bond(slot, [&](const FamilyBond& bond) { sum += body.internal.bond_stiffness(slot, bond) * bond.volume; });
    stiffness[static_cast<std::size_t>(particle)] = sum;
  });
  const double stiffest = *std::max_element(stiffness.begin(), stiffness.end()) + contact.stiffness;
  if (!(stiffest > 0)) return std::numeric_limits<double>::infinity();
  if (contact.damping == 0) return std::sqrt(2 * body.particles.density() / stiffest);
  return longest_step(2 * stiffest / body.particles.density(), 2 * contact.damping / body.particles.density());
}

double own_stable_step(const Body& body, const ShortRange::Bound& contact) {
  constexpr double margin = 1.02;  // what Lanczos' method finds is up to 0.7 % below
  // the highest frequency of two springs together is at most that of both in their stiffest modes (Weyl's inequality)
  const double squared = margin * stiffest_mode(body) + 2 * contact.stiffness / body.particles.density();
  if (!(squared > 0)) return std::numeric_limits<double>::infinity();
  const double damping = 2 * contact.damping / body.particles.density();
  return longest_step(squared, damping);
}

namespace {

/// Largest eigenvalue of a symmetric 3×3 matrix (Smith, Commun. ACM 4 (1961) 168).
double largest_eigenvalue(const double (&m)[3][3]) {
  const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3;
  double off = 0, deviator[3][3];
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      deviator[r][s] = m[r][s] - (r == s ? mean : 0);
      off += deviator[r][s] * deviator[r][s];
    }
  const double p = std::sqrt(off / 6);
  if (p == 0) return mean;
  const auto& d = deviator;
  const double determinant =
      d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  const double angle = std::acos(std::clamp(determinant / (2 * p * p * p), -1.0, 1.0)) / 3;
  return mean + 2 * p * std::cos(angle);
}

}  // namespace

double exact_stable_step(const Body& body) {
  const OrdinaryStateForce* force = body.internal.ordinary_state();
  if (!force || !body.family.stencil()) {
    const double stiffest = stiffest_mode(body);
    return stiffest > 0 ? 2 / std::sqrt(stiffest) : std::numeric_limits<double>::infinity();
  }
  constexpr int intervals = 24;
  const OrdinaryState& law = force->law();
  const Stencil& stencil = *body.family.stencil();
  const double wave = std::numbers::pi / stencil.spacing() / intervals;
  const int layers = body.particles.is_plane() ? 0 : intervals;
  double stiffest = 0;
  for (int kx = 0; kx <= intervals; ++kx)  // the lattice's symmetry leaves k_x >= k_y >= k_z >= 0
    for (int ky = 0; ky <= kx; ++ky)
      for (int kz = 0; kz <= std::min(ky, layers); ++kz) {
        double m[3][3] = {};
        Vec3d t{};
        for (const StencilBond& bond : stencil.bonds()) {
          const Vec3d n = bond.direction;
          const double phase = bond.length * wave * (kx * n.x + ky * n.y + kz * n.z);
          const double stretch = law.bond_stiffness(bond.length) * bond.volume * (1 - std::cos(phase));
          for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t s = 0; s < 3; ++s) m[r][s] += stretch * n[r] * n[s];
          t += (law.d() * law.weights(bond.length).dilatation * bond.volume / bond.length * std::sin(phase)) * n;
        }
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s) m[r][s] += 2 * law.a() * t[r] * t[s];
        stiffest = std::max(stiffest, largest_eigenvalue(m));
      }
  return 2 * std::sqrt(body.particles.density() / stiffest);
}

}  // namespace perimpact
