/// Polygons of any number of corners, as panels.
#pragma once

#include <span>

#include "mesh/panels.hpp"

namespace fccda {

/// Adds a polygon: one of three or four corners as it is, a larger one cut into triangles over its own corners: a fan from
/// the first where that can be, as in every convex one, else by cutting ears off (Meisters, American Mathematical Monthly 82 (1975)
/// 648), both as seen along its mean normal. `out` must hold its vertices already. False, and nothing is added, where it cannot be cut:
/// fewer than three corners, sides that cross one another as seen so, or more than 500 corners and no fan (ears can take time with the
/// cube of their number).
[[nodiscard]] bool add_polygon(Panels& out, std::span<const int> corners);

}  // namespace fccda
