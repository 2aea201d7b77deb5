/// The coordinate axis of a round shape.
#pragma once

#include "mesh/panels.hpp"

namespace fccda {

/// A coordinate axis.
enum class Axis { x, y, z };

/// Rotates panels made about the axis z to another axis, by cyclic exchange of the coordinates, which preserves the orientation: +x becomes
/// +y for the axis x, and +z for the axis y.
inline void turn_axis(Panels& panels, Axis axis) {
  for (Vec3d& v : panels.vertices) {
    if (axis == Axis::x) v = {v.z, v.x, v.y};
    if (axis == Axis::y) v = {v.y, v.z, v.x};
  }
}

}  // namespace fccda
