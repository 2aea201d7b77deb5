/// Stable (critical) time step.
#pragma once

#include "perimpact/body/body.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

/// Silling and Askari (Comput. Struct. 83 (2005) 1526): √(2 ρ/Σ_j C_ij V_j), C_ij = 4 b ω_e G_ij, least over all particles [s]. A bound for bond
/// forces with surface correction, without the dilatation. For correspondence, C_ij is that of springs stiffer than the material
/// (Correspondence::spring_bound), so that the bound is a third below the limit. With the short-range force, each particle has the largest
/// possible number of contacts in addition: with ω² = 2 Σ/ρ of all springs and D = 2 Σ/ρ of all
/// dashpots the step is (√(D² + 4 ω²) - D)/ω², at which a damped oscillation of symplectic Euler begins to grow.
double silling_askari_step(const Body& body, const ShortRange::Bound& contact = {});

/// Stable step for every material, Poisson's ratio, surface and correction and any bond failure [s]: that of Silling and Askari if the
/// dilatation stores no energy (a <= 0) or little enough, else 2/ω with
///
///   ρ ω² = max_j λ_max(Σ_i C_ij V_i n nᵀ) + Σ_i C_ij V_i + 2a S_j max_i g_i² S_i,   S_i = Σ_k w_ik + |Σ_k w_ik n|,   w_ik = d ω_θ |ξ| G_θ v V_k
///
/// i over j and its family. This is a norm of the stiffness (largest |Ku| for |u_i| <= 1), hence an upper bound of its largest eigenvalue;
/// no term grows when bonds break, since S = max_e Σ w (1 + n·e) (docs/theory/time_step.md). Two passes over the bonds.
double safe_stable_step(const Body& body, const ShortRange::Bound& contact = {});

/// Critical time step of this body with its surfaces, corrections and intact bonds: 2/ω of its stiffest mode [s] (integrate/stiffest_mode.hpp);
/// infinite without bonds. Too long by about 0.1 %; costs 40 force evaluations on a copy.
double exact_stable_step(const Body& body);
double exact_stable_step(double stiffest_mode);  ///< the same, from ω² [1/s²]

/// Stable step of this body with its surfaces, including contact between fragments [s]: 2/ω, ω² = 1.02 times that of its stiffest mode (Lanczos'
/// method converges from below) plus, by Weyl's inequality, that of the contacts. Longer than the estimate; costs 40 force evaluations.
double own_stable_step(const Body& body, const ShortRange::Bound& contact);
double own_stable_step(double stiffest_mode, double density, const ShortRange::Bound& contact);  ///< the same, from ω² [1/s²] and ρ [kg/m³]

}  // namespace perimpact
