/// Rigid motion of an impactor between frames: the rotation and translation that map its panels from the first frame.
#pragma once

#include <optional>
#include <span>

#include "base/vec3.hpp"

namespace perimpact::report {

/// x = turn · X + shift.
struct RigidMotion {
  fccda::Mat3 turn = fccda::Mat3::identity();
  fccda::Vec3d shift;  ///< [m]
};

/// Determines the motion from three distant points; nothing where another point deviates by more than `tolerance` [m], or the numbers of points
/// differ.
std::optional<RigidMotion> rigid_motion(std::span<const fccda::Vec3d> from, std::span<const fccda::Vec3d> to, double tolerance);

}  // namespace perimpact::report
