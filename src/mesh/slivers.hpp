/// Slivers: triangles whose corners lie on a line, as programs make them where a straight edge of one face carries vertices of its
/// neighbour. Leaving one out would tear the surface open along its sides; so the triangle beyond its longest side takes the vertex
/// in the middle:
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

/// Has a triangle of these corners an area: is it more than `flat` [m] high above its longest side?
bool has_area(std::span<const Vec3d> vertices, const std::array<int, 3>& corners, double flat);

/// Removes the slivers among the triangles in the way above, in passes, because the triangle beyond may be a sliver too. Those that have
/// none beyond (at a rim), or several, are left out. What was cut keeps its panel; the order of the others stays. Returns the number of
/// slivers found. Expects no repeated triangles and three different corners in each.
std::size_t absorb_slivers(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices, double flat);

}  // namespace fccda
