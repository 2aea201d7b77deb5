/// What looks wrong with an impactor before a run, a sentence each; none where all is well. Listed with remedies in
/// docs/guide/diagnoses.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// The body an impactor is to strike, at t = 0.
struct Target {
  std::string name;
  double spacing;         ///< [m]
  double contact_radius;  ///< [m]
  Vec3d size{};           ///< [m]
  Vec3d velocity{};       ///< [m/s]
};

using Diagnosis = std::optional<std::string>;

Diagnosis inside_out(const Impactor& impactor);                                     ///< the file's normals pointed inward
Diagnosis goes_through_itself(const Impactor& impactor);                            ///< panels of one body of the file cross
Diagnosis is_cut(const Impactor& impactor);                                         ///< at edges of more than two panels
Diagnosis panels_too_fine(const Impactor& impactor, const Target& target);          ///< median below a quarter of the spacing
Diagnosis panels_too_coarse(const Impactor& impactor, const Target& target);        ///< facets more than half a spacing off their curve
Diagnosis panels_of_another_unit(const Impactor& impactor, const Target& target);   ///< an edge longer than a hundred bodies
Diagnosis falls_between(const Impactor& impactor, const Target& target);            ///< thinner than two spacings in two directions
Diagnosis step_through(const Impactor& impactor, const Target& target, double dt);  ///< a step's way exceeds thickness or spacing

/// So many particles lie behind an open surface: nearest to its panels rather than its rim, on the side that the normals point away from.
std::size_t particles_behind(const Impactor& impactor, const Particles& particles);
Diagnosis starts_behind(const Impactor& impactor, const Target& target, const Particles& particles);  ///< such particles at t = 0

/// All that concern a target, but for its particles.
std::vector<std::string> diagnose(const Impactor& impactor, const Target& target, double dt);

}  // namespace perimpact
