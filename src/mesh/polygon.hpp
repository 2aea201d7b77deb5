/// Convex polygons cut by planes across the axes: what remains of a panel in a box, or beyond it.
#pragma once

#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Corners in order around. Empty, a point or a line where a cut left no more.
using Polygon = std::vector<Vec3d>;

enum class Side { below, above };

/// The part of a convex polygon on one side of the plane x[axis] = at, the plane included. New corners lie on the plane to the bit, so
/// that the parts on both sides together are the whole.
Polygon part_of(const Polygon& polygon, Side side, std::size_t axis, double at);

Box bounds_of(const Polygon& polygon);

}  // namespace fccda
