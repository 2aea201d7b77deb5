/// Local coordinate frame: origin and rotation.
#pragma once

#include "base/quaternion.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Local axes in global coordinates. Without rotation the transformation is bitwise exact.
struct Frame {
  fccda::Mat3 turn = fccda::Mat3::identity();
  Vec3d origin{};  ///< [m]

  Vec3d to_world(const Vec3d& local) const { return turn * local + origin; }
  Vec3d to_local(const Vec3d& world) const { return fccda::transpose(turn) * (world - origin); }
};

/// `rotate` [rad]: about the axes x, y and z of the outer frame, in this order, as FileSurface::rotate.
inline Frame frame_of(const Vec3d& position, const Vec3d& rotate) {
  if (rotate == Vec3d{}) return {.origin = position};
  using fccda::Quaternion;
  return {(Quaternion::from_rotation({0, 0, rotate.z}) * Quaternion::from_rotation({0, rotate.y, 0}) * Quaternion::from_rotation({rotate.x, 0, 0})).matrix(),
          position};
}

/// The frame `inner`, given in the frame `outer`, in global coordinates.
inline Frame operator*(const Frame& outer, const Frame& inner) { return {outer.turn * inner.turn, outer.to_world(inner.origin)}; }

}  // namespace perimpact
