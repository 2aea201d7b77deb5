#include "fccda/rigid_body/rigid_body.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

/// Solves a x = b by cofactors; a is symmetric and positive definite.
Vec3d solve(const Mat3& a, const Vec3d& b) {
  const Vec3d cofactors[3] = {cross(a.row[1], a.row[2]), cross(a.row[2], a.row[0]), cross(a.row[0], a.row[1])};
  return (b.x * cofactors[0] + b.y * cofactors[1] + b.z * cofactors[2]) / dot(a.row[0], cofactors[0]);
}

bool positive_definite(const Mat3& a) {
  const double first = a.row[0].x, second = a.row[0].x * a.row[1].y - a.row[0].y * a.row[1].x;
  return first > 0 && second > 0 && dot(a.row[0], cross(a.row[1], a.row[2])) > 0;
}

void expect_usable(const RigidBodyProperties& properties, const FreeDegrees& degrees) {
  if (!(properties.mass > 0 && std::isfinite(properties.mass)))
    throw InputError("rigid body: the mass is " + in_words(properties.mass) + " kg, but it must be positive and finite.");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expect_finite(properties.inertia.row[axis], "rigid body: a row of the inertia");
    if (!(properties.added_mass[axis] >= 0 && std::isfinite(properties.added_mass[axis])))
      throw InputError("rigid body: the added mass is " + in_words(properties.added_mass) + " kg, but no component may be negative or infinite.");
  }
  const Mat3& inertia = properties.inertia;
  constexpr double rounding = 1e-9;  // of products of the same numbers in another order
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < r; ++c)
      if (std::fabs(inertia.row[r][c] - inertia.row[c][r]) > rounding * (inertia.row[0].x + inertia.row[1].y + inertia.row[2].z))
        throw InputError("rigid body: the inertia is not symmetric: " + in_words(inertia.row[r][c]) + " and " + in_words(inertia.row[c][r]) +
                         " kg m2 must be equal.");
  expect_finite(properties.centre_of_mass, "rigid body: the centre of mass");
  if (degrees.any_rotation() && !positive_definite(properties.inertia))
    throw InputError("rigid body: a rotation is free, but the inertia is not positive definite; give the inertia or constrain the rotations.");
}

/// Checks that a step has a duration, and that the poses at its ends determine the rotation, at most π.
void expect_step(double dt, const Vec3d& spin) {
  if (!(dt >= 0 && std::isfinite(dt))) throw InputError("rigid body: the step lasts " + in_words(dt) + " s, but it must be finite and not negative.");
  const double angle = dt * norm(spin);
  if (angle > std::numbers::pi)
    throw InputError("rigid body: it turns by " + in_words(angle) + " rad in a step of " + in_words(dt) +
                     " s, but the poses at its ends determine at most half a turn; use a shorter step.");
}

}  // namespace

RigidBody::RigidBody(const RigidBodyProperties& properties, const Pose& pose, const Vec3d& velocity, const Vec3d& angular_velocity, const FreeDegrees& degrees)
    : properties_(properties), degrees_(degrees), com_(pose.to_world(properties.centre_of_mass)), velocity_(velocity), spin_(angular_velocity) {
  expect_usable(properties, degrees);
  expect_usable(pose, "rigid body: ");
  expect_finite(velocity, "rigid body: the velocity");
  expect_finite(angular_velocity, "rigid body: the angular velocity");
  place(pose.attitude());
}

Mat3 RigidBody::inertia() const { return pose_.rotation() * properties_.inertia * transpose(pose_.rotation()); }

double RigidBody::kinetic_energy() const {
  double twice = properties_.mass * squared_norm(velocity_) + dot(spin_, inertia() * spin_);
  for (std::size_t axis = 0; axis < 3; ++axis) twice += properties_.added_mass[axis] * velocity_[axis] * velocity_[axis];
  return 0.5 * twice;
}

Vec3d RigidBody::momentum() const {
  Vec3d momentum = properties_.mass * velocity_;
  for (std::size_t axis = 0; axis < 3; ++axis) momentum[axis] += properties_.added_mass[axis] * velocity_[axis];
  return momentum;
}

Vec3d RigidBody::angular_momentum(const Vec3d& point) const { return inertia() * spin_ + cross(com_ - point, momentum()); }

void RigidBody::place(const Quaternion& attitude) {
  const Pose turned({}, attitude);
  pose_ = Pose(com_ - turned.turn_to_world(properties_.centre_of_mass), attitude);
}

Vec3d RigidBody::spin_of(const Mat3& inertia, const Vec3d& angular, const Vec3d& prescribed) const {
  Mat3 reduced = inertia;
  Vec3d right = angular;
  for (std::size_t fixed = 0; fixed < 3; ++fixed) {
    if (degrees_.rotation(fixed)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      right[axis] -= reduced.row[axis][fixed] * prescribed[fixed];
      reduced.row[axis][fixed] = 0;
    }
    reduced.row[fixed] = {};
    reduced.row[fixed][fixed] = 1;
    right[fixed] = prescribed[fixed];
  }
  Vec3d spin = solve(reduced, right);
  for (std::size_t fixed = 0; fixed < 3; ++fixed)
    if (!degrees_.rotation(fixed)) spin[fixed] = prescribed[fixed];  // exactly: the solution is rounded
  return spin;
}

Quaternion RigidBody::turned(const Quaternion& attitude, const Vec3d& angular, double dt) const {
  Vec3d spin = spin_;  // of the end of the previous substep: an initial guess
  constexpr int max_iterations = 100;
  constexpr double enough = 4 * std::numeric_limits<double>::epsilon();
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const Mat3 rotation = (Quaternion::from_rotation(0.5 * dt * spin) * attitude).normalised().matrix();
    const Vec3d next = spin_of(rotation * properties_.inertia * transpose(rotation), angular, spin_);
    const double change = norm(next - spin), size = norm(next);
    spin = next;
    if (change <= enough * size) break;
  }
  return (Quaternion::from_rotation(dt * spin) * attitude).normalised();
}

Motion RigidBody::advance(double dt) {
  expect_step(dt, spin_);
  const Pose before = pose_;
  com_ += dt * velocity_;
  if (spin_ == Vec3d{}) {
    place(pose_.attitude());
    return {before, pose_, dt, properties_.centre_of_mass};
  }
  const Vec3d angular = inertia() * spin_;
  if (degrees_.any_rotation()) {
    // Yoshida, Phys. Lett. A 150 (1990) 262: three steps of a symmetric second-order method compose one of fourth order.
    const double outer = 1 / (2 - std::cbrt(2.0)), inner = 1 - 2 * outer;
    Quaternion attitude = pose_.attitude();
    for (const double share : {outer, inner, outer}) attitude = turned(attitude, angular, share * dt);
    place(attitude);
    spin_ = spin_of(angular);
  } else {
    place((Quaternion::from_rotation(dt * spin_) * pose_.attitude()).normalised());
  }
  count_work_on_rotations(angular, {});
  return {before, pose_, dt, properties_.centre_of_mass};
}

Twist RigidBody::velocity_change(const Vec3d& linear, const Vec3d& angular) const {
  Twist change;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (degrees_.translation(axis)) change.velocity[axis] = linear[axis] / (properties_.mass + properties_.added_mass[axis]);
  if (degrees_.any_rotation()) change.spin = spin_of(inertia(), angular, {});
  return change;
}

void RigidBody::add_impulse(const Vec3d& linear, const Vec3d& angular) {
  expect_finite(linear, "rigid body: the impulse");
  expect_finite(angular, "rigid body: the angular impulse");
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (degrees_.translation(axis))
      velocity_[axis] += linear[axis] / (properties_.mass + properties_.added_mass[axis]);
    else
      constraint_work_ -= linear[axis] * velocity_[axis];
  const Vec3d before = inertia() * spin_;
  if (degrees_.any_rotation()) spin_ = spin_of(before + angular);
  count_work_on_rotations(before, angular);
}

void RigidBody::count_work_on_rotations(const Vec3d& before, const Vec3d& angular) {
  const Vec3d taken = inertia() * spin_ - before - angular;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!degrees_.rotation(axis)) constraint_work_ += spin_[axis] * taken[axis];
}

void RigidBody::drive(std::size_t degree, double velocity) {
  if (degree >= 6 || degrees_.free[degree])
    throw InputError("rigid body: degree of freedom " + std::to_string(degree) +
                     " is free, so its velocity cannot be prescribed; constrain it, or choose a constrained one of 0 to 5.");
  expect_finite(velocity, "rigid body: the prescribed velocity");
  const double before = kinetic_energy();
  if (degree < 3) {
    velocity_[degree] = velocity;
  } else {
    const Vec3d angular = inertia() * spin_;
    spin_[degree - 3] = velocity;
    if (degrees_.any_rotation()) spin_ = spin_of(angular);
  }
  constraint_work_ += kinetic_energy() - before;
}

}  // namespace fccda
