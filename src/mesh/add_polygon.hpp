/// Triangulation of polygons with any number of corners into panels.
#pragma once

#include <span>

#include "mesh/panels.hpp"

namespace fccda {

/// Adds a polygon. One of three or four corners is added as it is; a larger one is triangulated without new vertices. A fan from the first
/// corner is used if it is valid, as for every convex polygon, otherwise ear clipping (Meisters, American Mathematical Monthly 82 (1975)
/// 648), both in projection along the mean normal. `out` must contain the vertices already. Returns false, and adds nothing, for fewer
/// than three corners, for sides that cross in projection, and for more than 500 corners without a valid fan (the cost of ear clipping can
/// be cubic).
[[nodiscard]] bool add_polygon(Panels& out, std::span<const int> corners);

}  // namespace fccda
