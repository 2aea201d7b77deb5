/// Where an impactor is in a picture: the rotation and shift that carry its panels there from the first picture.
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

/// Made from three points far apart; nothing where any other point is then off by more than `tolerance` [m], or they are not as many.
std::optional<RigidMotion> rigid_motion(std::span<const fccda::Vec3d> from, std::span<const fccda::Vec3d> to, double tolerance);

}  // namespace perimpact::report
