/// Slivers: triangles with collinear corners, as generated where a straight edge of one face contains vertices of its neighbour. Dropping
/// one would open the surface along its sides. So the triangle beyond its longest side takes the middle vertex:
///
///        d                d
///       / \              /|\         m is the middle corner of the sliver (a, m, c)
///      /   \     →      / | \        and lies on its longest side (a, c)
///     a--m--c          a--m--c
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// True if a triangle with these corners has an area: if its height above its longest side exceeds `flat` [m].
bool has_area(std::span<const Vec3d> vertices, const std::array<int, 3>& corners, double flat);

/// Removes the slivers among the triangles as above, in passes, because the triangle beyond may be a sliver too. Slivers with no triangle
/// beyond (at a boundary edge), or with several, are dropped. Divided triangles keep their panel; the order of the others is kept. Returns
/// the number of slivers found. Expects no repeated triangles and three different corners in each.
std::size_t absorb_slivers(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices, double flat);

}  // namespace fccda
