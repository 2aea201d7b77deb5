/// How a run starts, up to where bonds are made: bodies are filled with particles, impactors are placed, and particles that would be
/// inside one are refused, taken out of their body, or put on its surface (docs/theory/contact.md, "At t = 0").
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Particles of a body that were inside an impactor, or nearer to it than the contact radius, and were removed or put on its surface.
struct InitialPenetration {
  std::size_t impactor, body;      ///< index
  std::vector<std::size_t> slots;  ///< ascending
  double furthest = 0;             ///< [m] that any of them was moved
};

/// How well particles fill a solid.
struct FilledMass {
  double solid;      ///< [kg]
  double particles;  ///< [kg] before any were removed

  double excess() const { return particles / solid - 1; }  ///< [-] of the particles over the solid
};

struct Start {
  std::vector<Particles> particles;                      ///< of each body
  std::vector<std::optional<FilledMass>> filled_masses;  ///< of each body that fills a solid whose volume is known
  std::vector<Impactor> impactors;
  std::vector<InitialPenetration> inside;

  /// Throws SetupError: a set-up too large for the machine, impactors that cannot be made, particles inside where the deck refuses that or
  /// where there is no place for them.
  explicit Start(const Setup& setup);

 private:
  Start(const Setup& setup, std::span<const Discretisation> bodies);
};

/// The largest magnitude of stretch (|x_j - x_i| - |ξ|)/|ξ| among the bonds of these particles.
double largest_stretch(const Body& body, std::span<const std::size_t> slots);

/// One sentence an entry: how many particles, which way they went, and what that did to their bonds.
std::vector<std::string> warnings_of(std::span<const InitialPenetration> inside, const Setup& setup, std::span<const Body> bodies);

}  // namespace perimpact
