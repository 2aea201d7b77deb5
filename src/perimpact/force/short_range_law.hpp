/// What two particles without an intact bond do to one another when they come too near: a spring, and where the deck asks for it a dashpot
/// and friction (docs/theory/short_range.md).
///
///   overlap    o = d_ij - r > 0,  r = |x_j - x_i|,  n = (x_j - x_i)/r
///   distance   d_ij = min(0.9 |X_j - X_i|, q_own Δ) in one body,  q Δ between bodies;  Δ = (Δ_i + Δ_j)/2            [m]
///   spring     K = k V_i V_j,  k = 15 c/δ,  c = 18 κ/(π δ⁴) in space, 12 κ/(π h δ³) in the plane             [N/m], [N/m⁷]
///   normal     F_n = max(0, K o - 2 ζ √(K m) ṙ),  ṙ = n·w,  w = v_j - v_i,  m = m_i m_j/(m_i + m_j)                  [N]
///   friction   F_t = µ F_n w_t/max(|w_t|, v_reg, 4 µ F_n dt/m),   w_t = w - ṙ n                                      [N]
///
/// d_ij and the factor 15 are those of EMU (Silling, EMU Theory Manual, 2005, p. 18) as LAMMPS has them (pair_peri_pmb). In space and in the
/// plane c is the bond-based constant of the same bulk modulus. Two bodies are springs in series: k is the harmonic mean of theirs.
#pragma once

#include <cmath>

#include "fccda/core/vec3.hpp"
#include "perimpact/material/isotropic.hpp"

namespace perimpact {

using fccda::Vec3d;

struct ShortRangeLaw {
  double stiffness_factor = 15;         ///< [-]
  double distance_ratio = 1;            ///< [-] q, between bodies
  double debris_distance_ratio = 1.35;  ///< [-] q_own, within a body
  double friction = 0;                  ///< [-] µ
  double friction_speed = 0.01;         ///< [m/s] v_reg
  double damping_ratio = 0;             ///< [-] ζ

  /// k [N/m⁷] of a body; `thickness` [m] of a plane one.
  double stiffness(const IsotropicElastic& elastic, double horizon, double thickness) const;
};

/// Of unbonded particles in one body none repels before it has come this much nearer than it was at first.
inline constexpr double share_of_first_distance = 0.9;

/// How many particles touch one at the most, as far as stability is concerned: the nearest of a close packing.
inline constexpr double most_touching = 12;

/// Steps in which friction ends the sliding of two particles at the soonest. A particle with n touches, two thirds of whose directions lie across a
/// given one, loses at most 2 n/(3 · 4) of its sliding speed in a step, which for n = 12 is 2: no more than turns it round.
inline constexpr double slowest_stop = 4;

/// ζ with which two particles that collide freely part with e times the speed of their approach; the dashpot never pulls. With
/// ζ = sin φ, e = exp(-2 (π/2 - φ) tan φ); beyond ζ = 1, with ζ = cosh ψ, e = exp(-2 ψ coth ψ). Derived from the linear oscillator that ends
/// when its force is zero, as Schwager and Pöschel do (Granular Matter 9 (2007) 465). `restitution` in (0, 1].
double damping_ratio_of(double restitution);

/// Of the springs of two bodies, one after the other [N/m⁷].
inline double in_series(double k1, double k2) { return 2 * k1 * k2 / (k1 + k2); }

/// Two particles nearer than their contact distance.
struct Touch {
  double overlap;       ///< [m] o
  Vec3d direction;      ///< n, from i to j
  Vec3d velocity;       ///< [m/s] w
  double stiffness;     ///< [N/m] K
  double reduced_mass;  ///< [kg] m
};

/// Forces on particle i [N]; those on j are the opposite, to the last bit.
struct TouchForce {
  Vec3d spring, dashpot, friction;
  double energy;  ///< [J] of the spring
};

inline TouchForce force_of(const Touch& touch, const ShortRangeLaw& law, double dt) {
  const double spring = touch.stiffness * touch.overlap, apart = dot(touch.direction, touch.velocity);
  double normal = spring;
  if (law.damping_ratio > 0) normal = std::fmax(0.0, spring - 2 * law.damping_ratio * std::sqrt(touch.stiffness * touch.reduced_mass) * apart);
  TouchForce force{-spring * touch.direction, (spring - normal) * touch.direction, {}, 0.5 * spring * touch.overlap};
  if (law.friction > 0) {
    const Vec3d along = touch.velocity - apart * touch.direction;
    const double most = law.friction * normal;
    // a touch takes at most a quarter of what would end the sliding of the two within the step: a dozen of them cannot make it grow
    const double speed = std::fmax(std::fmax(norm(along), law.friction_speed), slowest_stop * most * dt / touch.reduced_mass);
    force.friction = (most / speed) * along;
  }
  return force;
}

}  // namespace perimpact
