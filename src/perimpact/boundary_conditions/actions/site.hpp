/// Where a boundary condition acts: body, particles, and its key in the deck.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fccda/rigid_body/piecewise_linear.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"
#include "perimpact/particles/particles.hpp"

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

struct BoundarySite {
  const BoundedParticles& of;
  std::string key;  ///< "bodies.plate.boundary_conditions.grip.fixed"

  /// Slots of the particle set, ascending; all where its name is empty. Throws SetupError if it does not exist.
  std::vector<std::uint32_t> slots(const std::string& particle_set) const;

  /// Factor [-] on a load against time; 1 where both are empty. Throws SetupError for an invalid table, as does table().
  fccda::PiecewiseLinear factor(const std::vector<double>& times, const std::vector<double>& factors) const;
  static fccda::PiecewiseLinear table(const std::string& key, const std::vector<double>& times, const std::vector<double>& values);
};

/// A face of a body along the axes, indexed as in face_words.
struct BodyFace {
  std::size_t axis;
  double sign;  ///< of its outward normal
  explicit BodyFace(int index) : axis(static_cast<std::size_t>(index / 2)), sign(index % 2 == 0 ? 1 : -1) {}
  Vec3d normal() const {
    Vec3d n{};
    n[axis] = sign;
    return n;
  }
};

/// Those of the slots, ascending, whose particle is the outermost of them in its lattice row towards the face, on all ranks. Collective.
std::vector<std::uint32_t> outermost(const Particles& particles, std::span<const std::uint32_t> slots, const BodyFace& face);

}  // namespace perimpact
