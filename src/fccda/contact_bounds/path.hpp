/// The path of a point during a step.
#pragma once

#include "base/vec3.hpp"

namespace fccda {

/// Straight, in the body frame.
struct Path {
  Vec3d start, end;  ///< [m]

  double length() const { return norm(end - start); }                           ///< [m]
  Vec3d at(double fraction) const { return start + fraction * (end - start); }  ///< [m] position at a fraction from 0 to 1
};

}  // namespace fccda
