/// Relocation of points that lie inside the surface before the first step. They have no path, so only the nearest position outside can be
/// used.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fccda/detect/path_test.hpp"

namespace fccda {

/// The position at the contact radius from the surface's closest point, in the body frame; if other parts of the surface are nearer than that,
/// farther out until it is clear of everything. Nothing if there is none (in a wedge sharper than about 10°).
std::optional<Vec3d> nearest_outside(const PathTest& test, const Vec3d& point);

/// The same for points in the world frame, with the body at `pose`.
std::vector<std::optional<Vec3d>> nearest_outside(const PathTest& test, std::span<const Vec3d> points, const Pose& pose);

}  // namespace fccda
