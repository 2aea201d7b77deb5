/// Position and attitude of a rigid body, and its motion within a step.
#pragma once

#include <cmath>
#include <string>

#include "base/quaternion.hpp"
#include "base/vec3.hpp"

namespace fccda {

/// Position and attitude of a body frame in the world frame. Stores its rotation matrix, so that rotating a point costs nine products.
class Pose {
 public:
  Pose() = default;
  /// `attitude` must be of unit length. It is stored bitwise, so that a restart is exact.
  explicit Pose(const Vec3d& position, const Quaternion& attitude = {})
      : position_(position), attitude_(attitude), to_world_(matrix_of(attitude_)), to_body_(transpose(to_world_)) {}

  const Vec3d& position() const { return position_; }       ///< [m] of the body frame's origin
  const Quaternion& attitude() const { return attitude_; }  ///< rotation from the body frame to the world frame
  const Mat3& rotation() const { return to_world_; }        ///< body to world

  Vec3d to_world(const Vec3d& point) const { return to_world_ * point + position_; }  ///< [m] position in the world frame
  Vec3d to_body(const Vec3d& point) const { return to_body_ * (point - position_); }  ///< [m] position in the body frame
  Vec3d turn_to_world(const Vec3d& vector) const { return to_world_ * vector; }       ///< direction in the world frame
  Vec3d turn_to_body(const Vec3d& vector) const { return to_body_ * vector; }         ///< direction in the body frame

 private:
  // Of an attitude that is not of unit length, as in single precision (expect_usable), the matrix scales: the surface is then larger in one direction of
  // the conversion than in the other, and relocated points are inside. Rounding is left alone, so that a matrix is that of its bits.
  static Mat3 matrix_of(const Quaternion& q) {
    constexpr double rounding = 1e-12;
    const double squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    return std::fabs(squared - 1) > rounding && squared > 0 ? q.normalised().matrix() : q.matrix();
  }

  Vec3d position_;
  Quaternion attitude_;
  Mat3 to_world_ = Mat3::identity();
  Mat3 to_body_ = Mat3::identity();
};

/// A body's motion over one step: from its pose at t0 to that at t1 = t0 + dt. In between it rotates uniformly about its centre by the shorter
/// angle, and the centre moves straight.
struct Motion {
  Pose t0, t1;     ///< at the two ends of the step
  double dt = 0;   ///< [s]
  Vec3d centre{};  ///< [m] in the body frame; for a rigid body its centre of mass
};

/// Throws InputError if a pose is not finite or its attitude is not of unit length, to 1e-6. `whose`: begins the sentence.
void expect_usable(const Pose& pose, const std::string& whose);

/// The same for both poses of a motion, its centre and its duration, which may be 0 here.
void expect_usable(const Motion& motion);

/// The rotation from t0 to t1 as a vector along its axis (world), with its angle [rad] as length, at most π.
inline Vec3d rotation_vector(const Motion& motion) {
  const Quaternion& a = motion.t0.attitude();
  const Quaternion turn = motion.t1.attitude() * Quaternion{a.w, -a.x, -a.y, -a.z};
  const Vec3d axis = turn.w < 0 ? Vec3d{-turn.x, -turn.y, -turn.z} : Vec3d{turn.x, turn.y, turn.z};
  const double sine = norm(axis);
  return sine > 0 ? (2 * std::atan2(sine, std::fabs(turn.w)) / sine) * axis : Vec3d{};
}

/// Angle between the two attitudes [rad], from 0 to π.
inline double rotation_angle(const Motion& motion) { return norm(rotation_vector(motion)); }

/// The pose of the body at t0 + fraction · dt.
inline Pose pose_at(const Motion& motion, double fraction) {
  const Quaternion attitude = (Quaternion::from_rotation(fraction * rotation_vector(motion)) * motion.t0.attitude()).normalised();
  const Vec3d start = motion.t0.to_world(motion.centre), end = motion.t1.to_world(motion.centre);
  return Pose(start + fraction * (end - start) - Pose({}, attitude).turn_to_world(motion.centre), attitude);
}

/// Bound [m] of the travel of points within `radius` of `centre` (body frame): the displacement from end to end, plus the sagitta R θ²/8 of
/// the arc over its chord.
inline double travel_bound(const Motion& motion, const Vec3d& centre, double radius) {
  const double angle = rotation_angle(motion);
  const double shift = norm(motion.t1.to_world(centre) - motion.t0.to_world(centre));
  return shift + radius * (2 * std::sin(0.5 * angle) + angle * angle / 8);
}

/// Velocity of the material point of the body at `point` (world frame) at t1, averaged over the step [m/s].
inline Vec3d mean_velocity(const Motion& motion, const Vec3d& point) { return (point - motion.t0.to_world(motion.t1.to_body(point))) / motion.dt; }

}  // namespace fccda
