/// A Cartesian frame aligned with an axis.
#pragma once

#include "base/vec3.hpp"

namespace fccda {

/// The third coordinate is along the axis. Angles count from the first towards the second: for the axis z from x towards y, for x from y
/// towards z, for y from z towards x, and for an oblique axis from the coordinate axis that follows its largest component.
class CylinderFrame {
 public:
  /// `axis` need not be a unit vector.
  CylinderFrame(const Vec3d& origin, const Vec3d& axis) : origin_(origin), axis_(normalised(axis)) {
    const Vec3d size{std::fabs(axis_.x), std::fabs(axis_.y), std::fabs(axis_.z)};
    const std::size_t largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Vec3d follower{};
    follower[(largest + 1) % 3] = 1;
    u_ = normalised(follower - dot(follower, axis_) * axis_);
    v_ = cross(axis_, u_);
  }

  /// [m]
  Vec3d to_frame(const Vec3d& point) const {
    const Vec3d from = point - origin_;
    return {dot(from, u_), dot(from, v_), dot(from, axis_)};
  }
  Vec3d to_body(const Vec3d& place) const { return origin_ + place.x * u_ + place.y * v_ + place.z * axis_; }  ///< [m] inverse of to_frame()

 private:
  Vec3d origin_, axis_, u_, v_;
};

}  // namespace fccda
