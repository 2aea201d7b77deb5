/// Time step of a run: that of the deck if it is stable, or 0.9 of the estimate of the critical one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

/// Time step and its stability limits over all bodies.
struct Stability {
  double step;      ///< [s] time step used
  double estimate;  ///< [s] lower bound of the critical time step (safe_stable_step)
  /// [s] critical time step of the bodies with their surfaces; computed only if the step exceeds 0.9 of the estimate (exact_stable_step)
  std::optional<double> exact;
};

/// With time.relax, the step is that of an increment. Adds a warning for a step that may be unstable, or that resolves modes of an elastic impactor poorly or
/// for their sake only. Throws SetupError for a step that is unstable, longer than the run or does not resolve modes, and if neither bodies nor the deck
/// determine one.
Stability find_step(const Setup& setup, std::span<Body> bodies, std::span<const Impactor> impactors, const std::optional<ShortRange>& fragments,
                    std::vector<std::string>& warnings);

}  // namespace perimpact
