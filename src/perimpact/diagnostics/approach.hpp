/// When an impactor will first touch a body, if both keep their velocities: what `check` tells before a run.
#pragma once

#include <optional>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

struct Approach {
  double gap;                   ///< [m] between the surface and the nearest particle's contact sphere at t = 0
  std::optional<double> touch;  ///< [s]; absent where nothing touches until `end`
};

/// `contact_radius` [m]; `end` [s]. Exact for the straight and turning motion of the impactor and the straight one of the particles, to
/// 1e-9 of the surface's size, by conservative advancement on the distance; the region of the impactor is not looked at.
Approach approach(const Impactor& impactor, const Particles& particles, double contact_radius, double end);

}  // namespace perimpact
