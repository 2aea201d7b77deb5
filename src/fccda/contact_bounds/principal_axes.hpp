/// The axes of a surface's shape.
#pragma once

#include <array>

#include "mesh/surface.hpp"

namespace fccda {

/// How a surface's area lies about its centroid.
struct AreaAxes {
  Vec3d centroid{};                ///< [m] of the area
  std::array<Vec3d, 3> direction;  ///< unit, at right angles, along which the second moments ∫ x xᵀ dA are extreme
};

/// The axis of a body that repeats itself by turns of less than half a turn (three blades and more) is one of them, and goes through the
/// centroid. Components that are rounding are zero, and the largest is positive.
AreaAxes area_axes(const Surface& surface);

}  // namespace fccda
