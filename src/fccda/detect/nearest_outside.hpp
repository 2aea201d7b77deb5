/// Where a point belongs that lies inside the surface before anything has moved: it has no path, so the nearest place outside is all
/// there is to go by.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fccda/detect/path_test.hpp"

namespace fccda {

/// The place at the contact radius from the surface's closest point, in the frame of the body; where other parts of the surface are
/// nearer than that, further out until it is clear of everything. Nothing where that cannot be had (in a wedge sharper than about 10°).
std::optional<Vec3d> nearest_outside(const PathTest& test, const Vec3d& point);

/// The same for points of the world, with the body at `pose`.
std::vector<std::optional<Vec3d>> nearest_outside(const PathTest& test, std::span<const Vec3d> points, const Pose& pose);

}  // namespace fccda
