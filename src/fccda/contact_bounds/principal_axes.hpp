/// Principal axes of a surface's area.
#pragma once

#include <array>

#include "mesh/surface.hpp"

namespace fccda {

/// The distribution of a surface's area about its centroid.
struct AreaAxes {
  Vec3d centroid{};                ///< [m] of the area
  std::array<Vec3d, 3> direction;  ///< orthonormal, along which the second moments ∫ x xᵀ dA are extreme
};

/// The axis of a body with rotational symmetry of order three or more (three blades and more) is one of them, and goes through the centroid.
/// Components within rounding are set to zero, and the largest is positive.
AreaAxes area_axes(const Surface& surface);

}  // namespace fccda
