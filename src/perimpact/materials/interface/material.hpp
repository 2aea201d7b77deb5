/// What a material provides to the solver: a specialisation Material<…Setup> in `materials/<name>/material.hpp`, of static members only.
///
///   using Force = std::variant<…>;            the force kernels it may choose (internal_force.hpp states what they have)
///   static constexpr bool has_bonds           bending calibration: the stiffness of the bonds is that of the material
///   influences(setup)                         ω_θ, ω_e of the linear material with the same constants
///   correction(body)                          surface correction
///   make_force(setup, parts)                  the kernel of one body
///   memory(setup, question)                   what its arrays need
///
/// OrdinaryStateMaterial (ordinary_state/material.hpp) is the base of those that consist of bonds and a dilatation.
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

class OrdinaryState;

template <class Setup>
struct Material;

/// What a force is made of.
struct MaterialParts {
  const BodySetup& body;
  const IsotropicElastic& elastic;  ///< of the body, 3-D or 2-D, with bending calibration
  const OrdinaryState& linear_law;  ///< the ordinary state-based law with these constants and influences(setup)
  CorrectionKind correction;
  const Particles& particles;
  Family& family;  ///< before initial cracks are cut
  std::optional<BreakingRule> rule;
  std::vector<double> strength;  ///< [-] of each slot (damage/strength.hpp); where empty, 1

  double thickness() const { return particles.thickness().value_or(1); }  ///< [m] of a 2-D body; 1 in 3-D
  Breaking breaking() const { return rule ? Breaking(*rule, strength, family, particles) : Breaking(); }
};

/// Lengths of the arrays of a body, before it exists.
struct ArrayLengths {
  double particles;    ///< slots with a particle
  double slots;        ///< of arrays without slack
  double with_slack;   ///< of arrays with slack for a stencil (SlotArray)
  double rows;         ///< bonds of eight slots: bytes of the bits
  double entries = 0;  ///< of a list; 0 for a stencil
  double tables = 0;   ///< bonds in tables of shared surface factors
  double surface = 1;  ///< share of the slots whose surface factors differ from 1
  double partial = 1;  ///< share of the slots in packs without eight complete families

  bool is_list() const { return entries > 0; }
};

struct MemoryQuestion {
  const BodySetup& body;
  CorrectionKind correction;
  const ArrayLengths& lengths;
};

/// [bytes] of the Breaking of a body: strengths in tension, and with hardening those under pressure, with the marks of packs.
inline double breaking_memory(const BodySetup& body, const ArrayLengths& length) {
  if (!body.elastic().may_fail() || !body.failure) return 0;
  const FailureSetup& failure = *body.failure;
  const bool limits = failure.compression.as<CompressionFailure>() != CompressionFailure::none, hardens = !limits && failure.compression_hardening > 0;
  const bool differs = limits || failure.weibull_modulus || !failure.no_fail.empty();
  return ((differs ? 1 : 0) + (hardens ? 1 : 0)) * sizeof(double) * length.with_slack + (hardens ? length.slots + length.slots / 8 : 0);
}

/// [bytes] of a material.
struct MaterialMemory {
  double at_rest;         ///< during the run
  double setting_up = 0;  ///< more, while the body is built
};

/// Surface correction that the deck asks for; `automatic` is energy.
inline CorrectionKind correction_of_deck(const BodySetup& body) {
  switch (body.surface_correction.as<SurfaceCorrection>()) {
    case SurfaceCorrection::volume:
      return CorrectionKind::volume;
    case SurfaceCorrection::none:
      return CorrectionKind::none;
    default:
      return CorrectionKind::energy;
  }
}

/// Calls f(setup, Material<…>) with the setup of the body's material.
template <class F>
auto with_material(const BodySetup& body, const F& f) {
  return std::visit([&]<class Setup>(const Setup& setup) { return f(setup, Material<Setup>{}); }, body.material);
}

}  // namespace perimpact
