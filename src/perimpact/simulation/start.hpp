/// Initial state of a run before bonds are created: bodies are discretised, impactors are placed, and particles inside an impactor are
/// refused, removed, or projected onto its surface (docs/theory/contact.md, "At t = 0").
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/timers.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/discretisation/filled_mass.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Particles of a body initially inside an impactor, or nearer to it than the contact radius, that were removed or projected.
struct InitialPenetration {
  std::size_t impactor, body;      ///< index
  std::vector<std::size_t> slots;  ///< of this rank, ascending
  std::size_t particles = 0;       ///< on all ranks
  double furthest = 0;             ///< [m] largest displacement by projection
};

struct Start {
  Ranks* ranks;                                          ///< which share the bodies
  fccda::Stages stages;                                  ///< of the set-up so far
  std::vector<Particles> particles;                      ///< of each body
  std::vector<std::optional<FilledMass>> filled_masses;  ///< of each body whose solid has a known volume
  std::vector<Impactor> impactors;
  std::vector<InitialPenetration> inside;

  /// Throws SetupError for insufficient memory, invalid impactors, or initial penetration that is refused or cannot be resolved.
  /// `loads`: of each body in an earlier run, by which ranks divide them, or none.
  explicit Start(const Setup& setup, fccda::Stages given = fccda::Stages(), Ranks& ranks = alone(), std::span<const MeasuredLoad> loads = {});

 private:
  /// What is read before memory is allocated for bodies and searches.
  struct Read {
    std::vector<Discretisation> bodies;
    std::vector<ImpactorSurface> surfaces;
  };
  static Read read(const Setup& setup, fccda::Stages& stages, const Ranks& ranks, std::span<const MeasuredLoad> loads);
  Start(const Setup& setup, fccda::Stages& given, Read read, Ranks& ranks, std::span<const MeasuredLoad> loads);
};

/// The largest magnitude of stretch (|x_j - x_i| - |ξ|)/|ξ| among the bonds of these particles.
double largest_stretch(const Body& body, std::span<const std::size_t> slots);

/// One sentence per entry: number of particles, their treatment, and the resulting bond stretch.
std::vector<std::string> warnings_of(std::span<const InitialPenetration> inside, const Setup& setup, std::span<const Body> bodies);

}  // namespace perimpact
