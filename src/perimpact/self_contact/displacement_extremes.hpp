/// Extremes of the displacements of particles since a list of pairs was built, which decide when it is out of date.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "perimpact/self_contact/contacting_body.hpp"

namespace perimpact {

/// Extremes over some particles.
struct DisplacementExtremes {
  Vec3d low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};  ///< [m] of each component
  double furthest = 0;                                                             ///< [m²] largest squared distance from the drift

  constexpr void include(const DisplacementExtremes& other) {
    low = min(low, other.low), high = max(high, other.high);
    furthest = std::max(furthest, other.furthest);
  }
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/// Successive particles of a list in successive slots of a body.
struct ParticleRun {
  std::size_t particle;  ///< the first
  std::uint32_t body, slot, count;
};

/// Of the particles in these runs. `reference` [m]: of the particles of the list; `drift` [m]: their approximate common displacement.
DisplacementExtremes displacement_extremes(std::span<const ParticleRun> runs, std::span<const ContactingBody> bodies, const VectorArray& reference,
                                           const Vec3d& drift);

}  // namespace perimpact
