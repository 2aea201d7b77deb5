/// Builds a boundary condition from its setup.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/all_boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"

namespace perimpact {

/// Slots of a named particle set of the body, ascending. Throws SetupError with that key if it does not exist.
using SlotsOfRegion = std::function<std::vector<std::size_t>(const std::string& region, const std::string& key)>;

/// Body and particles on which boundary conditions act.
struct BoundedParticles {
  const BodySetup& body;
  const IsotropicElastic& elastic;
  const Particles& particles;
  const SlotsOfRegion& slots_of;
};

/// Builds one boundary condition of the body. Throws SetupError for an unknown particle set, a missing area of a point cloud, or an invalid
/// table.
NamedBoundaryCondition boundary_condition_of(const BoundaryConditionSetup& boundary, const BoundedParticles& of);

/// The slots, ascending, whose particle is the outermost of its lattice row towards the face (indexed as in face_words).
std::vector<std::uint32_t> outermost(const Lattice& lattice, std::span<const std::uint32_t> slots, int face);

}  // namespace perimpact
