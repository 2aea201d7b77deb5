/// Linear peridynamic solid: the ordinary state-based material with one influence function, normalised by the family of each particle.
#pragma once

#include "perimpact/materials/linear_solid/setup.hpp"
#include "perimpact/materials/ordinary_state/material.hpp"

namespace perimpact {

template <>
struct Material<LinearSolidSetup> : OrdinaryStateMaterial {
  static Influences influences(const LinearSolidSetup& setup) { return {setup.influence.as<Influence>(), setup.influence.as<Influence>()}; }
  static CorrectionKind correction(const BodySetup&) { return CorrectionKind::family; }
};

}  // namespace perimpact
