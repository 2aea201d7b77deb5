/// How long a time step may be.
#pragma once

#include "perimpact/body/body.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

/// Silling and Askari (Comput. Struct. 83 (2005) 1526): √(2 ρ/Σ_j C_ij V_j), C_ij = 4 b ω_e G_ij, least over all particles [s]. A bound of the bonds,
/// surface correction included; it knows nothing of the dilatation. Of correspondence C_ij is that of springs which are
/// stiffer than the material (Correspondence::spring_bound), so that it is a bound, short of the limit by a third.
/// Where the short-range force is on, a particle has besides as many contacts as can be: with ω² = 2 Σ/ρ of all springs and D = 2 Σ/ρ of all
/// dashpots the step is (√(D² + 4 ω²) - D)/ω², at which a damped oscillation of symplectic Euler begins to grow.
double silling_askari_step(const Body& body, const ShortRange::Bound& contact = {});

/// A step that is stable for every material, Poisson's ratio, surface and correction, whatever bonds break [s]: Silling and Askari's where the
/// dilatation stores nothing (a <= 0) or leaves room for it, else 2/ω with
///
///   ρ ω² = max_j λ_max(Σ_i C_ij V_i n nᵀ) + Σ_i C_ij V_i + 2a S_j max_i g_i² S_i,   S_i = Σ_k w_ik + |Σ_k w_ik n|,   w_ik = d ω_θ |ξ| G_θ v V_k
///
/// i over j and its family. It is a norm of the stiffness (largest length of Ku for |u_i| <= 1), hence no less than its largest eigenvalue; no term grows when
/// bonds break, since S = max_e Σ w (1 + n·e) (docs/theory/time_step.md). Two passes over the bonds.
double safe_stable_step(const Body& body, const ShortRange::Bound& contact = {});

/// The step at which this body, with its surfaces, corrections and the bonds that it has now, becomes unstable: 2/ω of its stiffest mode [s]
/// (simulation/stiffest_mode.hpp); infinite where it has no bonds. Too long by 0.1 % or so, for 40 evaluations of its forces on a copy.
double exact_stable_step(const Body& body);
double exact_stable_step(double stiffest_mode);  ///< the same, from ω² [1/s²]

/// A step that this body with its surfaces surely stands, contact between fragments included [s]: 2/ω, ω² = 1.02 of that of its stiffest mode (Lanczos'
/// method comes from below) and, by Weyl's inequality, that of the contacts. Longer than the estimate, for 40 evaluations of the body's forces.
double own_stable_step(const Body& body, const ShortRange::Bound& contact);
double own_stable_step(double stiffest_mode, double density, const ShortRange::Bound& contact);  ///< the same, from ω² [1/s²] and ρ [kg/m³]

}  // namespace perimpact
