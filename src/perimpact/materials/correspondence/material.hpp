/// Correspondence material: what it provides to the solver.
#pragma once

#include <variant>

#include "perimpact/materials/correspondence/correspondence_force.hpp"
#include "perimpact/materials/correspondence/setup.hpp"
#include "perimpact/materials/interface/material.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

template <>
struct Material<CorrespondenceSetup> {
  using Force = std::variant<CorrespondenceForce<3>, CorrespondenceForce<2>>;

  static constexpr bool has_bonds = false;
  static Influences influences(const CorrespondenceSetup& setup) { return {setup.influence.as<Influence>(), setup.influence.as<Influence>()}; }
  static CorrectionKind correction(const BodySetup&) { return CorrectionKind::none; }
  /// Throws SetupError if no particle has a deformation gradient.
  static Force make_force(const CorrespondenceSetup& setup, const MaterialParts& parts);
  static MaterialMemory memory(const CorrespondenceSetup& setup, const MemoryQuestion& question);
};

}  // namespace perimpact
