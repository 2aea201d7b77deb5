/// From what a deck says about a boundary to the particles it acts on and how.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/all_boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

/// Slots of a named region of the body, ascending. Throws SetupError, with that key, where there is none.
using SlotsOfRegion = std::function<std::vector<std::size_t>(const std::string& region, const std::string& key)>;

/// The particles that a body's boundaries act on.
struct BoundedParticles {
  const BodySetup& body;
  const IsotropicElastic& elastic;
  const Particles& particles;
  const SlotsOfRegion& slots_of;
};

/// One of the body's boundaries. Throws SetupError: a region that is none, an area that a cloud of points lacks, a table that is
/// none.
NamedBoundaryCondition boundary_condition_of(const BoundaryConditionSetup& boundary, const BoundedParticles& of);

/// Those of the slots (ascending) whose particle is the last one of its row of the lattice towards that face (counted as in
/// face_words), ascending.
std::vector<std::uint32_t> outermost(const Lattice& lattice, std::span<const std::uint32_t> slots, int face);

}  // namespace perimpact
