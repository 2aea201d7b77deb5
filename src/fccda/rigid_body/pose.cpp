#include "fccda/rigid_body/pose.hpp"

#include "base/finite.hpp"

namespace fccda {

void expect_usable(const Pose& pose, const std::string& whose) {
  expect_finite(pose.position(), whose + "the position of the pose");
  const Quaternion& q = pose.attitude();
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  constexpr double rounding = 1e-6;  // of an attitude in single precision
  if (!(std::fabs(length - 1) <= rounding))
    throw InputError(whose + "the attitude of the pose is a quaternion of length " + in_words(length) + ", but it must be 1; normalise it.");
}

void expect_usable(const Motion& motion) {
  expect_usable(motion.t0, "motion at t0: ");
  expect_usable(motion.t1, "motion at t1: ");
  expect_finite(motion.centre, "motion: the centre of its turn");
  if (!(motion.dt >= 0 && std::isfinite(motion.dt)))
    throw InputError("motion: the step lasts " + in_words(motion.dt) + " s, but it must be finite and not negative.");
}

}  // namespace fccda
