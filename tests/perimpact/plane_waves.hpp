/// Plane waves of the infinite lattice, ordinary state-based materials: an oracle for the limit of bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fixtures/larger.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/materials/correspondence/small_matrix.hpp"

namespace fixtures {

using namespace perimpact;

/// 2/ω [s] of the stiffest wave over wave vectors of the first Brillouin zone, 24 intervals to π/Δ along each axis:
/// M(k) = Σ 4 b ω_e v V n nᵀ (1 - cos k·ξ) + 2a T Tᵀ,  T = d Σ ω_θ |ξ| v V n sin(k·ξ),  ω² = largest eigenvalue of M/ρ.
inline double plane_wave_limit(const Body& body) {
  constexpr int intervals = 24;
  const OrdinaryState& law = body.internal.ordinary_state()->law();
  const Stencil& stencil = *body.family.stencil();
  const double wave = std::numbers::pi / stencil.spacing() / intervals;
  const int layers = body.particles.is_plane() ? 0 : intervals;
  double stiffest = 0;
  for (int kx = 0; kx <= intervals; ++kx)  // the lattice's symmetry leaves k_x >= k_y >= k_z >= 0
    for (int ky = 0; ky <= kx; ++ky)
      for (int kz = 0; kz <= std::min(ky, layers); ++kz) {
        SmallMatrix<double, 3> m{};
        Vec3d t{};
        for (const StencilBond& bond : stencil.bonds()) {
          const Vec3d n = bond.direction;
          const double phase = bond.length * wave * (kx * n.x + ky * n.y + kz * n.z);
          const double stretch = law.bond_stiffness(bond.length) * bond.volume * (1 - std::cos(phase));
          for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t s = 0; s < 3; ++s) m.m[r][s] += stretch * n[r] * n[s];
          t += (law.d() * law.weights(bond.length).dilatation * bond.volume / bond.length * std::sin(phase)) * n;
        }
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s) m.m[r][s] += 2 * law.a() * t[r] * t[s];
        for (const double value : eigen_of(m).value) stiffest = fixtures::larger(stiffest, value);
      }
  return 2 * std::sqrt(body.particles.density() / stiffest);
}

}  // namespace fixtures
