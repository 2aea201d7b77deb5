/// Do two triangles go through one another?
#pragma once

#include <array>
#include <optional>

#include "base/vec3.hpp"

namespace fccda {

using TriangleCorners = std::array<Vec3d, 3>;

/// +1 where d lies above the plane of a, b, c (which run counterclockwise seen from above), -1 below, 0 where rounding may decide. What is
/// not 0 is exact: the determinant is compared with a bound of its own error (Shewchuk, Discrete & Computational Geometry 18 (1997) 305,
/// filter A of orient3d).
int side_of_plane(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

/// The middle of the line along which they cross (Möller, Journal of Graphics Tools 2 (1997) 25: each has corners on both sides of the
/// other's plane, and what the planes cut out of the two overlaps); nothing where they are apart, touch, share an edge, lie in one plane,
/// or cross over less than 1e-9 of their longest edge. Triangles that share a corner may cross from there.
std::optional<Vec3d> crossing_of(const TriangleCorners& one, const TriangleCorners& other);

}  // namespace fccda
