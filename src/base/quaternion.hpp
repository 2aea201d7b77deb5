/// Attitude (orientation) of a rigid body as a unit quaternion.
#pragma once

#include <cmath>

#include "base/vec3.hpp"

namespace fccda {

/// w + (x, y, z), of unit length: rotates a vector from the body frame into the world frame.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;  ///< [-] components; the default is the identity

  /// Rotation by |rotation| [rad] about the direction of `rotation`.
  static Quaternion from_rotation(const Vec3d& rotation) {
    const double angle = norm(rotation);
    // sin(a/2)/a, by its series where a is too small for the division
    const double factor = angle > 1e-8 ? std::sin(0.5 * angle) / angle : 0.5 - angle * angle / 48;
    return {std::cos(0.5 * angle), factor * rotation.x, factor * rotation.y, factor * rotation.z};
  }

  /// The rotation b followed by a.
  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }

  /// The same rotation with unit length, against drift by rounding.
  Quaternion normalised() const {
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
  }

  /// The rotation matrix, body to world.
  Mat3 matrix() const {
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
  }
};

}  // namespace fccda
