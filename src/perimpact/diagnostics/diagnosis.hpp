/// Warnings about an impactor before a run, one sentence each; empty if there is nothing to report. docs/guide/diagnoses.md lists them
/// with remedies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Body to be impacted, at t = 0.
struct Target {
  std::string name;
  double spacing;         ///< [m]
  double contact_radius;  ///< [m]
  Vec3d size{};           ///< [m]
  Vec3d velocity{};       ///< [m/s]
};

using Diagnosis = std::optional<std::string>;

Diagnosis inside_out(const Impactor& impactor);                                     ///< the file's normals pointed inward
Diagnosis goes_through_itself(const Impactor& impactor);                            ///< self-intersection within one body of the file
Diagnosis is_cut(const Impactor& impactor);                                         ///< at non-manifold edges
Diagnosis panels_too_fine(const Impactor& impactor, const Target& target);          ///< median below a quarter of the spacing
Diagnosis panels_too_coarse(const Impactor& impactor, const Target& target);        ///< facets more than half a spacing off their curve
Diagnosis panels_of_another_unit(const Impactor& impactor, const Target& target);   ///< an edge longer than a hundred bodies
Diagnosis falls_between(const Impactor& impactor, const Target& target);            ///< thinner than two spacings in two directions
Diagnosis step_through(const Impactor& impactor, const Target& target, double dt);  ///< motion per step exceeds thickness or spacing

/// Number of particles behind an open surface: nearest to its panels rather than its boundary edges, on the side opposite to the normals.
std::size_t particles_behind(const Impactor& impactor, const Particles& particles);
Diagnosis starts_behind(const Impactor& impactor, const Target& target, const Particles& particles);  ///< such particles at t = 0

struct KindAndSentence {
  std::string_view kind;
  std::string sentence;
};
/// All warnings about a target, except those about its particles.
std::vector<KindAndSentence> diagnose(const Impactor& impactor, const Target& target, double dt);

}  // namespace perimpact
