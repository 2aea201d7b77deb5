/// Failure criterion of a body from its set-up, with the equivalent fracture energy and flexural strength.
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/breaking_rule.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Three equivalent parameters: each of them determines the other two (docs/theory/damage.md).
struct FailureCriterion {
  double stretch;            ///< [-] s_c
  double fracture_energy;    ///< [J/m²] G₀
  double flexural_strength;  ///< [Pa] σ_f of a plate with `layers` layers
  int layers;
};

/// Empty if bonds never break. `law`: of the body; for a correspondence material the linear law with the same constants.
std::optional<FailureCriterion> failure_criterion(const BodySetup& setup, const OrdinaryState& law, const Family& family, const Particles& particles);

/// Rule of bond failure for the criterion.
BreakingRule breaking_rule(const std::optional<FailureSetup>& setup, const FailureCriterion& criterion);

/// Strength of each slot (damage/strength.hpp); empty if it is 1 everywhere. `never`: slots of particles whose bonds never break.
std::vector<double> strength_of(const std::optional<FailureSetup>& setup, const Particles& particles, const std::vector<std::size_t>& never);

}  // namespace perimpact
