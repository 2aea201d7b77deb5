/// Fracture energy of a linear body and its critical stretch s_c: G₀ = k s_c² [J/m²] for separation along a plane.
///
///   bonds        k = 2π b ∫ ω_e |ξ|⁵ d|ξ|  in 3-D,  4 b h ∫ ω_e |ξ|⁴ d|ξ|  in 2-D (h: thickness): all bonds across the plane, each
///                with its energy 2 b ω_e |ξ|² s_c². For Madenci and Oterkus 3µδ and 6µδ/π; Silling and Askari (2005) for a = 0.
///                On a lattice, Σ over bonds of the stencil across a plane of its cells, so that a crack along it dissipates exactly G₀.
///   dilatation   Madenci and Oterkus (2014, ch. 6; 2-D as in Dorduncu et al., Comput. Struct. 299 (2024) 107395):
///                (3/4)⁴ (κ - 5µ/3) δ in 3-D, 16/(9π²) (κ - 2µ) δ in 2-D. These are squares of the integral of θ over the distance from
///                the plane. The integral of θ² itself is larger, 0.530 (κ - 5µ/3) δ and 0.272 (κ - 2µ) δ; the form of the literature
///                is used here. For ν = 1/4 in 3-D both vanish.
#pragma once

#include <cmath>
#include <numbers>

#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

/// k of the bonds in the continuum [J/m²].
inline double fracture_energy_of_bonds(const OrdinaryState& law, double horizon, double thickness) {
  const bool in_space = law.elastic().dimension == 3;
  constexpr int intervals = 2000;
  double integral = 0;  // Simpson's rule
  for (int n = 0; n <= intervals; ++n) {
    const double r = horizon * n / intervals;
    integral += (n == 0 || n == intervals ? 1 : n % 2 ? 4 : 2) * law.weights(r).stretch * r * r * (in_space ? r : 1);
  }
  integral *= horizon / intervals / 3;
  return in_space ? 2 * std::numbers::pi * law.b() * integral : 4 * law.b() * thickness * integral;
}

/// k of the dilatation [J/m²].
inline double fracture_energy_of_dilatation(const OrdinaryState& law, double horizon) {
  constexpr double pi = std::numbers::pi;
  return 2 * law.a() * (law.elastic().dimension == 3 ? 81.0 / 256 : 16 / (9 * pi * pi)) * horizon;
}

/// Critical stretch for a flexural strength. The strain of the outermost particles of a bent plate of n layers is (1 - 1/n) of that of its surface,
/// and the plate is to fail at the surface stress σ_f: s_c = (1 - 1/n) σ_f/E.
inline double stretch_of_flexural_strength(double strength, double youngs_modulus, int layers) { return (1 - 1.0 / layers) * strength / youngs_modulus; }
inline double flexural_strength_of_stretch(double stretch, double youngs_modulus, int layers) { return stretch * youngs_modulus / (1 - 1.0 / layers); }

}  // namespace perimpact
