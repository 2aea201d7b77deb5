/// Short-range force law between particles without an intact bond: a repulsive spring with optional dashpot and Coulomb friction
/// (docs/theory/short_range.md).
///
/// The spring is an embedded-atom potential (Daw and Baskes, Phys. Rev. B 29 (1984) 6443): it depends on the particle density around each
/// particle, and only this density is compared with a threshold. The smoothness of a face of particles is then that of the weight function,
/// whatever the stiffness and onset of contact.
///
///   weight     W(q) = (1 - q²/4)⁶ for q = r/a < 2,   a = q_d (Δ_i + Δ_j)/2,   r = |x_j - x_i|                            [-], [m]
///   density    ρ_i = Σ_j w_j W,   w_j = (Δ_j/a)^(d-1) in d dimensions, of all j without an intact bond                     [-]
///   overlap    o_i = max(0, ρ_i - b_i),  b_i the density at which contact begins, at least that of a face at the distance q_d Δ
///   energy     E = Σ_i ½ B_i o_i²,   B = k V² a²/(2 ρ̄'²),  ρ̄' of a face                                                  [J]
///   normal     F = max(0, S - 2 ζ √(K m) ṙ),  S = (B_i o_i w_j + B_j o_j w_i) |W'|/a,  K = (B_i w_j² + B_j w_i²) W'²/a²       [N]
///   friction   k_t s,  ṡ = w_t,  |k_t s| ≤ µ χ F;  w_t the relative velocity normal to n                                    [N]
///
/// k = 15 c/δ,  c = 18 κ/(π δ⁴) in 3-D, 12 κ/(π h δ³) in 2-D [N/m⁷]: two faces are as stiff as if each pair of opposite
/// particles were a spring k V_i V_j, as in EMU (Silling, EMU Theory Manual, 2005, p. 18) and LAMMPS (pair_peri_pmb).
#pragma once

#include <cmath>

#include "base/pack.hpp"
#include "base/vec3.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Parameters of the law.
struct ShortRangeLaw {
  double stiffness_factor = 15;  ///< [-]
  double distance_ratio = 1;     ///< [-] q_d
  double friction = 0;           ///< [-] µ
  double damping_ratio = 0;      ///< [-] ζ

  /// k [N/m⁷] of a body; `thickness` [m] of a 2-D body.
  double stiffness(const IsotropicElastic& elastic, double horizon, double thickness) const;
};

/// Support of the weight function, in a. With this exponent and support, the spurious tangential force between two square faces is at most 0.6 % of the
/// normal one at the distance a and 1.6 % at 0.7 a, in any relative phase; with a smaller support it is several times as large (theory page).
inline constexpr double weight_reach = 2;

/// Weight W as a function of q².
template <class Number>
FCCDA_HD Number contact_weight(Number q_squared) {
  const Number x = fccda::larger(Number(1.0) - Number(0.25) * q_squared, Number(0.0)), cube = x * x * x;
  return cube * cube;
}
/// -W'(q)/q as a function of q².
template <class Number>
FCCDA_HD Number contact_weight_slope(Number q_squared) {
  const Number x = fccda::larger(Number(1.0) - Number(0.25) * q_squared, Number(0.0)), square = x * x;
  return Number(3.0) * square * square * x;
}

/// Constants of two opposite faces of particles.
struct Face {
  double density;        ///< ρ at the distance a, in the phase where it is largest: equal lattices that continue one another contact at no less
  double slope;          ///< |ρ̄'|, the mean over all phases
  double oblique_share;  ///< χ: pairs are oblique to a face; without χ their friction would sum to µ/χ times the pressure
};
inline constexpr Face face_in_space{.density = 0.241455078125 * (1 + 1e-9), .slope = 1.118272, .oblique_share = 0.90};
inline constexpr Face face_in_plane{.density = 0.2112735 * (1 + 1e-9), .slope = 0.911014, .oblique_share = 1};

/// [a] opening up to which a crack closes where it opened; a wider one closes at its largest width less this.
inline constexpr double remembered_opening = 0.1;

/// Density stiffness B [J] of a particle; k [N/m⁷].
inline double density_stiffness(const Face& face, double k, double volume, double distance) {
  const double arm = volume * distance / face.slope;
  return 0.5 * k * (arm * arm);
}

/// B o [J] of a particle at a pressure [Pa] between two faces, 2 B o |ρ̄'|/(a V/Δ); a lattice of loose particles that is compressed from all sides to the
/// spacing a has the same pressure within 2 % (docs/theory/short_range.md).
inline double density_pressure(const Face& face, double pressure, double volume, double size, double distance) {
  return pressure * volume * distance / (2 * face.slope * size);
}

/// Ratio of tangential to normal spring stiffness: a face has some nine pairs per particle, with 1.0 to 1.4 times its normal stiffness in total.
inline constexpr double tangential_share = 1.0 / 6;

/// Upper bound for stability on the number of springs k V_i V_j that act on a particle. A cubic lattice compressed from all sides to the
/// contact distance has 5.3, and 2.9 of tangential springs; twelve are reached at 0.9 of that distance, with friction at 0.95 (docs/theory/short_range.md).
inline constexpr double most_in_contact = 12;

/// Damping ratio ζ for the coefficient of restitution e of two particles that collide freely; the dashpot never causes attraction. With
/// ζ = sin φ, e = exp(-2 (π/2 - φ) tan φ); beyond ζ = 1, with ζ = cosh ψ, e = exp(-2 ψ coth ψ). Derived from the linear oscillator that ends
/// when its force is zero, as Schwager and Pöschel do (Granular Matter 9 (2007) 465). `restitution` in (0, 1].
double damping_ratio_of(double restitution);

/// Stiffness of the springs of two bodies in series [N/m⁷].
inline double in_series(double k1, double k2) { return 2 * k1 * k2 / (k1 + k2); }

/// Two particles in contact.
struct ParticleContact {
  Vec3d direction;              ///< n, from i to j
  Vec3d velocity;               ///< [m/s] w = v_j - v_i
  double spring;                ///< [N] S
  double stiffness;             ///< [N/m] K
  double reduced_mass;          ///< [kg] m
  double tangential_stiffness;  ///< [N/m] k_t
  double oblique_share;         ///< [-] χ
};

/// Forces on particle i [N]; those on j are exactly opposite (bitwise).
struct ParticleContactForce {
  Vec3d normal, friction;
  double tangential_energy;                  ///< [J] of the tangential spring
  double friction_dissipation, damped_work;  ///< [J] dissipated in the last step, never negative
};

/// Contact force. `slip` [m]: extension s of the tangential spring, updated over the last step dt [s].
FCCDA_HD inline ParticleContactForce force_of(const ParticleContact& pair_contact, const ShortRangeLaw& law, double dt, Vec3d& slip) {
  const double apart = dot(pair_contact.direction, pair_contact.velocity);
  double normal = pair_contact.spring;
  if (law.damping_ratio > 0) normal = std::fmax(0.0, normal - 2 * law.damping_ratio * std::sqrt(pair_contact.stiffness * pair_contact.reduced_mass) * apart);
  ParticleContactForce force{-normal * pair_contact.direction, {}, 0, 0, (pair_contact.spring - normal) * apart * dt};
  if (law.friction > 0) {
    // the spring rotates with the pair and keeps its length
    Vec3d before = slip - dot(slip, pair_contact.direction) * pair_contact.direction;
    const double length = std::sqrt(dot(before, before));
    if (length > 0) before = (std::sqrt(dot(slip, slip)) / length) * before;
    const Vec3d reached = before + dt * (pair_contact.velocity - apart * pair_contact.direction);
    const double pull = pair_contact.tangential_stiffness * std::sqrt(dot(reached, reached)), most = law.friction * pair_contact.oblique_share * normal;
    slip = pull > most ? (most / pull) * reached : reached;
    force.friction = pair_contact.tangential_stiffness * slip;
    force.tangential_energy = 0.5 * pair_contact.tangential_stiffness * squared_norm(slip);
    // mean of the forces before and after the step, times the slip distance: together with the spring energy, exactly the work in leapfrog
    force.friction_dissipation = std::fmax(0.0, 0.5 * pair_contact.tangential_stiffness * dot(before + slip, reached - slip));
  }
  return force;
}

}  // namespace perimpact
