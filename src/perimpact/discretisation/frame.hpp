/// Where something is in the world, and how it is turned.
#pragma once

#include "base/quaternion.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Own axes in the world. Without a turn, coordinates keep their last bit.
struct Frame {
  fccda::Mat3 turn = fccda::Mat3::identity();
  Vec3d origin{};  ///< [m]

  Vec3d to_world(const Vec3d& local) const { return turn * local + origin; }
  Vec3d to_local(const Vec3d& world) const { return fccda::transpose(turn) * (world - origin); }
};

/// `rotate` [rad] turns about the axes x, y and z of the frame around it, in this order, as FileSurface::rotate does.
inline Frame frame_of(const Vec3d& position, const Vec3d& rotate) {
  if (rotate == Vec3d{}) return {.origin = position};
  using fccda::Quaternion;
  return {(Quaternion::from_rotation({0, 0, rotate.z}) * Quaternion::from_rotation({0, rotate.y, 0}) * Quaternion::from_rotation({rotate.x, 0, 0})).matrix(),
          position};
}

/// The frame `inner`, given in the frame `outer`, in the world.
inline Frame operator*(const Frame& outer, const Frame& inner) { return {outer.turn * inner.turn, outer.to_world(inner.origin)}; }

}  // namespace perimpact
