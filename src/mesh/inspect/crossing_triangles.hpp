/// Triangle–triangle intersection test.
#pragma once

#include <array>
#include <optional>

#include "base/vec3.hpp"

namespace fccda {

using TriangleCorners = std::array<Vec3d, 3>;

/// +1 if d lies above the plane of a, b, c (counterclockwise seen from above), -1 if below, 0 if rounding may decide. A nonzero result is
/// exact: the determinant is compared with an error bound (Shewchuk, Discrete & Computational Geometry 18 (1997) 305, filter A of
/// orient3d).
int side_of_plane(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

/// The midpoint of the intersection segment of two triangles (Möller, Journal of Graphics Tools 2 (1997) 25: each has corners on both sides
/// of the other's plane, and the intervals on the common line overlap). Nothing if they are disjoint, only touch, share an edge, are
/// coplanar, or cross over less than 1e-9 of their longest edge. Triangles that share a corner may cross from there.
std::optional<Vec3d> crossing_of(const TriangleCorners& one, const TriangleCorners& other);

}  // namespace fccda
