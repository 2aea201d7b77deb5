/// Time of first contact of an impactor with a body at constant velocities, for `check`.
#pragma once

#include <optional>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

struct Approach {
  double gap;                  ///< [m] between the surface and the nearest particle's contact sphere at t = 0
  std::optional<double> time;  ///< [s]; empty without contact until `end`
};

/// `contact_radius` [m]; `end` [s]. Conservative advancement on the distance, exact to 1e-9 of the surface's size for translation and rotation
/// of the impactor and translation of the particles. Contact bounds are ignored.
Approach approach(const Impactor& impactor, const Particles& particles, double contact_radius, double end);

}  // namespace perimpact
