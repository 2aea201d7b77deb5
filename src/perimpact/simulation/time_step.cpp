#include "perimpact/simulation/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/integrate/stiffest_mode.hpp"
#include "perimpact/simulation/short_range_of.hpp"

namespace perimpact {

namespace {

constexpr double safety = 0.9;  // factor on the estimate, which is a bound for linear bodies at rest

/// [rad/s] of the modes of all impactors; 0 without any.
double highest_frequency(std::span<const Impactor> impactors) {
  double highest = 0;
  for (const Impactor& impactor : impactors)
    if (const DeformingPart* part = impactor.deforming(); part && part->elastic())
      for (const fccda::Mode& mode : part->elastic()->modes()) highest = std::max(highest, mode.angular_frequency);
  return highest;
}

constexpr double automatic_angle = 0.5;  // ω Δt of the highest mode: the static deflection of a mode is 2 % too small (elastic_body.hpp)
constexpr double largest_angle = 2;      // there by 36 %

/// `automatic` [s] with regard to the bodies. Reduced so that modes are resolved; a given step that does not resolve them is refused.
double resolve_modes(const Setup& setup, double automatic, double highest, std::vector<std::string>& warnings) {
  if (highest == 0) return automatic;
  const double resolved = automatic_angle / highest;
  if (setup.time.step && *setup.time.step * highest > largest_angle)
    throw SetupError("time.step", fmt::format("the time step of {:.4g} s is too long for the highest mode of an elastic impactor ({:.4g} Hz); use at most "
                                              "{:.4g} s, or leave out high modes (elastic.highest_frequency).",
                                              *setup.time.step, highest / (2 * std::numbers::pi), resolved));
  if (setup.time.step && *setup.time.step > resolved * (1 + 1e-9))
    warnings.push_back(
        fmt::format("The time step of {:.4g} s resolves the highest mode of an elastic impactor ({:.4g} Hz) poorly: its static deflection is "
                    "{:.2g} % too small. Use at most {:.4g} s, or leave out high modes.",
                    *setup.time.step, highest / (2 * std::numbers::pi),
                    100 * (1 - 0.5 * *setup.time.step * highest / std::tan(0.5 * *setup.time.step * highest)), resolved));
  constexpr double much = 0.1;
  if (!setup.time.step && resolved < much * automatic)
    warnings.push_back(
        fmt::format("The highest mode of an elastic impactor ({:.4g} Hz) needs a time step of {:.4g} s, {:.3g} times shorter than the bodies need. "
                    "Leave out high modes with elastic.highest_frequency.",
                    highest / (2 * std::numbers::pi), resolved, automatic / resolved));
  return std::min(automatic, resolved);
}

}  // namespace

Stability find_step(const Setup& setup, std::span<Body> bodies, std::span<const Impactor> impactors, const std::optional<ShortRange>& fragments,
                    std::vector<std::string>& warnings) {
  Stability stability{0, std::numeric_limits<double>::infinity(), {}};
  const std::vector<ShortRange::Bound> bounds = fragments ? fragments->bounds(contacting_bodies(setup, bodies)) : std::vector<ShortRange::Bound>(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) stability.estimate = std::min(stability.estimate, safe_stable_step(bodies[b], bounds[b]));
  if (setup.time.relax) {
    stability.step = setup.time.end / setup.time.relax->increments;
    return stability;
  }
  const double of_bodies = safety * stability.estimate, automatic = resolve_modes(setup, of_bodies, highest_frequency(impactors), warnings);
  if (!setup.time.step && !std::isfinite(automatic))
    throw SetupError("time", "no body has bonds, so that the stable time step is undefined; give time.step, or use smaller spacings.");
  stability.step = setup.time.step.value_or(setup.time.end / std::ceil(setup.time.end / automatic));
  if (stability.step > setup.time.end)
    throw SetupError("time.step",
                     fmt::format("a time step of {:.4g} s is longer than the whole run of {:.4g} s; reduce it, or omit it.", stability.step, setup.time.end));
  constexpr double max_steps = 1e15;  // exact in double precision; thirty years at a million steps per second
  if (!(setup.time.end / stability.step <= max_steps))
    throw SetupError("time.end", fmt::format("the run would take {:.3g} steps of {:.3g} s; end it earlier, or increase the step.",
                                             setup.time.end / stability.step, stability.step));
  if (stability.step <= of_bodies * (1 + 1e-9)) return stability;
  double exact = std::numeric_limits<double>::infinity(), own = exact;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double stiffest = stiffest_mode(bodies[b]);
    exact = std::min(exact, exact_stable_step(stiffest));
    own = std::min(own, own_stable_step(stiffest, bodies[b].particles.density(), bounds[b]));
  }
  stability.exact = exact;
  if (stability.step >= exact)
    throw SetupError("time.step", fmt::format("the time step of {:.4g} s is {:.3g} times the critical time step of these bodies ({:.4g} s) and unstable; use "
                                              "at most {:.4g} s, or omit time.step.",
                                              stability.step, stability.step / exact, exact, automatic));
  if (stability.step > safety * own)
    warnings.push_back(fmt::format(
        "The time step of {:.4g} s is {:.3g} times the estimated stable step ({:.4g} s) and {:.3g} times the largest that is certainly stable "
        "for these bodies{} ({:.4g} s); it may be unstable. Use at most {:.4g} s.",
        stability.step, stability.step / automatic, automatic, stability.step / own, fragments ? " with fragments in contact" : "", own, safety * own));
  return stability;
}

}  // namespace perimpact
