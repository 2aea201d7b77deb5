/// How long a time step may be.
#pragma once

#include "perimpact/force/short_range.hpp"
#include "perimpact/simulation/body.hpp"

namespace perimpact {

/// Silling and Askari (Comput. Struct. 83 (2005) 1526): √(2 ρ/Σ_j C_ij V_j), C_ij = 4 b ω_e G_ij, least over all particles [s]. It is safe by a
/// factor near two in three dimensions for 0.1 <= ν <= 0.4 (physics notes 2.3), and knows of the surface correction. Of correspondence C_ij is
/// that of springs which are stiffer than the material (Correspondence::spring_bound), so that it is a bound, short of the limit by a third.
/// Where the short-range force is on, a particle has besides as many contacts as can be: with ω² = 2 Σ/ρ of all springs and D = 2 Σ/ρ of all
/// dashpots the step is (√(D² + 4 ω²) - D)/ω², at which a damped oscillation of symplectic Euler begins to grow.
double silling_askari_step(const Body& body, const ShortRange::Bound& contact = {});

/// The step at which the body becomes unstable: 2/ω of its stiffest wave or mode [s]; infinite where it has no bonds.
///
/// Ordinary state-based materials on a lattice: that of the infinite lattice, found over wave vectors of the first Brillouin zone (24 intervals to
/// π/Δ along each axis). M(k) = Σ 4 b ω_e v V n nᵀ (1 - cos k·ξ) + 2a T Tᵀ, T = d Σ ω_θ |ξ| v V n sin(k·ξ), ω² = largest eigenvalue of M/ρ.
/// All others: that of this body with its surfaces (simulation/stiffest_mode.hpp), too long by 0.1 % or so, for 40 evaluations of its forces.
double exact_stable_step(const Body& body);

/// A step that this body with its surfaces surely stands, contact between fragments included [s]: 2/ω, ω² = 1.02 of that of its stiffest mode (Lanczos'
/// method comes from below) and, by Weyl's inequality, that of the contacts. Longer than the estimate, for 40 evaluations of the body's forces.
double own_stable_step(const Body& body, const ShortRange::Bound& contact);

}  // namespace perimpact
