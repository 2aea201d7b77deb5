/// Rings of vertices about the axis z, and triangles between them, for cylinders and hubs.
#pragma once

#include "mesh/panels.hpp"

namespace fccda {

/// Equally spaced vertices about the axis z, counted from +x towards +y.
struct Ring {
  int first;
  int count;  ///< a multiple of 4, as circle_divisions gives
  int vertex(int k) const { return first + k % count; }
};

/// Adds the vertices of a ring, by symmetry from the first eighth of the circle, so that mirror images are bitwise identical.
Ring add_ring(Panels& out, int count, double radius, double z);

enum class Facing { up, down };

/// Triangles between two rings of any counts. With Facing::up, normals point along +z if `inner` is the smaller one, and away from the axis
/// if `inner` lies above `outer`. The next side is taken from the ring whose next side has its midpoint at the smaller angle, so that edges
/// between the rings stay within half a side of each.
void zip_rings(Panels& out, const Ring& inner, const Ring& outer, Facing facing);

/// A disc of rings from `rim`, of this radius and height, to a vertex on the axis.
void add_cap(Panels& out, const Ring& rim, double radius, double z, double panel, Facing facing);

}  // namespace fccda
