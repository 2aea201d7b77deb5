/// Ordinary state-based material: what it provides to the solver, and the base of materials that differ from it in constants or weights alone.
#pragma once

#include <variant>

#include "perimpact/materials/interface/material.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"
#include "perimpact/materials/ordinary_state/plastic_force.hpp"
#include "perimpact/materials/ordinary_state/setup.hpp"

namespace perimpact {

struct OrdinaryStateMaterial {
  using Force = std::variant<OrdinaryStateForce, PlasticForce>;

  static constexpr bool has_bonds = true;
  static Influences influences(const ElasticSetup&) { return madenci_oterkus_influences; }
  static CorrectionKind correction(const BodySetup& body) { return correction_of_deck(body); }
  static Force make_force(const ElasticSetup& setup, const MaterialParts& parts);
  static MaterialMemory memory(const ElasticSetup& setup, const MemoryQuestion& question, bool has_dilatation = true);
};

template <>
struct Material<OrdinaryStateSetup> : OrdinaryStateMaterial {};

}  // namespace perimpact
