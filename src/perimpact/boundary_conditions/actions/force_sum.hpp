/// Sums of forces on particles.
#pragma once

#include "base/vec3.hpp"

namespace perimpact {

/// Resultant and 2-norm of forces on particles.
struct ForceSum {
  fccda::Vec3d force{};  ///< [N]
  double squared = 0;    ///< [N²] Σ |F_i|²
  ForceSum& operator+=(const ForceSum& other) {
    force += other.force, squared += other.squared;
    return *this;
  }
};

}  // namespace perimpact
