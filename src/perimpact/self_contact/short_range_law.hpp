/// What particles without an intact bond do to one another when they come too near: a spring, and where the deck asks for it a dashpot and
/// friction (docs/theory/short_range.md).
///
/// The spring is an embedded-atom potential (Daw and Baskes, Phys. Rev. B 29 (1984) 6443): each particle feels how dense its surroundings are,
/// and only the density is compared with a threshold. A face of particles is then as smooth as the weight function makes its density, however
/// stiff contact is and however sharply it begins.
///
///   weight     W(q) = (1 - q²/4)⁶ for q = r/a < 2,   a = q_d (Δ_i + Δ_j)/2,   r = |x_j - x_i|                            [-], [m]
///   density    ρ_i = Σ_j w_j W,   w_j = (Δ_j/a)^(d-1) in d dimensions, of all j without an intact bond                     [-]
///   overlap    o_i = max(0, ρ_i - b_i),  b_i the density at which contact begins, at least that of a face at the distance q_d Δ
///   energy     E = Σ_i ½ B_i o_i²,   B = k V² a²/(2 ρ̄'²),  ρ̄' of a face                                                  [J]
///   normal     F = max(0, S - 2 ζ √(K m) ṙ),  S = (B_i o_i w_j + B_j o_j w_i) |W'|/a,  K = (B_i w_j² + B_j w_i²) W'²/a²       [N]
///   friction   k_t s,  ṡ = w_t,  |k_t s| ≤ µ χ F;  w_t the relative velocity across n                                    [N]
///
/// k = 15 c/δ,  c = 18 κ/(π δ⁴) in space, 12 κ/(π h δ³) in the plane [N/m⁷]: two faces are as stiff to one another as if each pair of particles that lie
/// opposite were a spring k V_i V_j, that of EMU (Silling, EMU Theory Manual, 2005, p. 18) and LAMMPS (pair_peri_pmb).
#pragma once

#include <cmath>

#include "base/vec3.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

using fccda::Vec3d;

struct ShortRangeLaw {
  double stiffness_factor = 15;  ///< [-]
  double distance_ratio = 1;     ///< [-] q_d
  double friction = 0;           ///< [-] µ
  double damping_ratio = 0;      ///< [-] ζ

  /// k [N/m⁷] of a body; `thickness` [m] of a plane one.
  double stiffness(const IsotropicElastic& elastic, double horizon, double thickness) const;
};

/// How far the weight function reaches, in a. With this exponent and reach the tangential force of two square faces on one another is at most 0.6 % of the
/// normal one at the distance a and 1.6 % at 0.7 a, in whatever phase they lie; with shorter reaches it is several times as large (theory page).
inline constexpr double weight_reach = 2;

/// W of q²
inline double contact_weight(double q_squared) {
  const double x = 1 - 0.25 * q_squared, cube = x * x * x;
  return x > 0 ? cube * cube : 0;
}
/// -W'(q)/q of q²
inline double contact_weight_slope(double q_squared) {
  const double x = 1 - 0.25 * q_squared, square = x * x;
  return x > 0 ? 3 * square * square * x : 0;
}

/// Of two faces of particles opposite one another.
struct Face {
  double density;        ///< ρ at the distance a, in the phase in which it is largest: equal lattices in each other's place touch at no less
  double slope;          ///< |ρ̄'|, the mean over all phases
  double oblique_share;  ///< χ: pairs are oblique to a face, and their friction along it would add up to µ/χ times the pressure
};
inline constexpr Face face_in_space{.density = 0.241455078125 * (1 + 1e-9), .slope = 1.118272, .oblique_share = 0.90};
inline constexpr Face face_in_plane{.density = 0.2112735 * (1 + 1e-9), .slope = 0.911014, .oblique_share = 1};

/// B [J] of a particle; k [N/m⁷].
inline double density_stiffness(const Face& face, double k, double volume, double distance) {
  const double arm = volume * distance / face.slope;
  return 0.5 * k * (arm * arm);
}

/// Tangential springs, over those of the two densities: a face has some nine pairs a particle, together two thirds as stiff as it is across.
inline constexpr double tangential_share = 1.0 / 6;

/// How many springs k V_i V_j hold a particle at the most, as far as stability is concerned: pressed from all sides to 0.6 of the distance at which
/// contact begins, and held by its tangential springs, it has 8.
inline constexpr double most_touching = 12;

/// ζ with which two particles that collide freely part with e times the speed of their approach; the dashpot never pulls. With
/// ζ = sin φ, e = exp(-2 (π/2 - φ) tan φ); beyond ζ = 1, with ζ = cosh ψ, e = exp(-2 ψ coth ψ). Derived from the linear oscillator that ends
/// when its force is zero, as Schwager and Pöschel do (Granular Matter 9 (2007) 465). `restitution` in (0, 1].
double damping_ratio_of(double restitution);

/// Of the springs of two bodies, one after the other [N/m⁷].
inline double in_series(double k1, double k2) { return 2 * k1 * k2 / (k1 + k2); }

/// Two particles that push one another.
struct Touch {
  Vec3d direction;              ///< n, from i to j
  Vec3d velocity;               ///< [m/s] w = v_j - v_i
  double spring;                ///< [N] S
  double stiffness;             ///< [N/m] K
  double reduced_mass;          ///< [kg] m
  double tangential_stiffness;  ///< [N/m] k_t
  double oblique_share;         ///< [-] χ
};

/// Forces on particle i [N]; those on j are the opposite, to the last bit.
struct TouchForce {
  Vec3d normal, friction;
  double tangential_energy;                  ///< [J] of the tangential spring
  double friction_dissipation, damped_work;  ///< [J] taken in the last step, never negative
};

/// `slip` [m]: of the tangential spring, s; brought to the end of the step dt [s] that led here.
inline TouchForce force_of(const Touch& touch, const ShortRangeLaw& law, double dt, Vec3d& slip) {
  const double apart = dot(touch.direction, touch.velocity);
  double normal = touch.spring;
  if (law.damping_ratio > 0) normal = std::fmax(0.0, normal - 2 * law.damping_ratio * std::sqrt(touch.stiffness * touch.reduced_mass) * apart);
  TouchForce force{-normal * touch.direction, {}, 0, 0, (touch.spring - normal) * apart * dt};
  if (law.friction > 0) {
    // the spring turns with the pair, and keeps its length
    Vec3d before = slip - dot(slip, touch.direction) * touch.direction;
    const double length = norm(before);
    if (length > 0) before = (norm(slip) / length) * before;
    const Vec3d reached = before + dt * (touch.velocity - apart * touch.direction);
    const double pull = touch.tangential_stiffness * norm(reached), most = law.friction * touch.oblique_share * normal;
    slip = pull > most ? (most / pull) * reached : reached;
    force.friction = touch.tangential_stiffness * slip;
    force.tangential_energy = 0.5 * touch.tangential_stiffness * squared_norm(slip);
    // the mean of the forces before and after the step, on the way that was slipped: with the spring's energy, exactly the work in leapfrog
    force.friction_dissipation = std::fmax(0.0, 0.5 * touch.tangential_stiffness * dot(before + slip, reached - slip));
  }
  return force;
}

}  // namespace perimpact
