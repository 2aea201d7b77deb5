/// Convex polygons clipped by axis-aligned planes: the part of a panel inside a box, or beyond it.
#pragma once

#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Corners in order around the polygon. Empty, a point or a line if clipping leaves no more.
using Polygon = std::vector<Vec3d>;

enum class Side { below, above };

/// The part of a convex polygon on one side of the plane x[axis] = at, the plane included. New corners lie exactly on the plane, so the
/// parts on both sides add up to the whole.
Polygon part_of(const Polygon& polygon, Side side, std::size_t axis, double at);

Box bounds_of(const Polygon& polygon);

}  // namespace fccda
