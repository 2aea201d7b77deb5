#include "fccda/respond/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fccda/respond/impulse_change.hpp"

namespace fccda {

namespace {

using Vector6 = std::array<double, 6>;

Vec3d first(const Vector6& v) { return {v[0], v[1], v[2]}; }
Vec3d second(const Vector6& v) { return {v[3], v[4], v[5]}; }

Vector6 product(const std::array<Vector6, 6>& rows, const Vector6& v) {
  Vector6 result{};
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c) result[r] += rows[r][c] * v[c];
  return result;
}

/// Solves a x = b by Gaussian elimination with partial pivoting.
Vector6 solve(std::array<Vector6, 6> a, Vector6 b) {
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k + 1; r < 6; ++r)
      if (std::fabs(a[r][k]) > std::fabs(a[pivot][k])) pivot = r;
    std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
    for (std::size_t r = k + 1; r < 6; ++r) {
      const double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < 6; ++c) a[r][c] -= factor * a[k][c];
      b[r] -= factor * b[k];
    }
  }
  for (std::size_t k = 6; k-- > 0;) {
    for (std::size_t c = k + 1; c < 6; ++c) b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
  return b;
}

/// Upper bound on the speed within the radius [m/s].
double speed(const Twist& twist, double radius) { return norm(twist.velocity) + radius * norm(twist.spin); }

Impulse operator+(const Impulse& a, const Impulse& b) { return {a.linear + b.linear, a.angular + b.angular}; }
Impulse operator-(const Impulse& a, const Impulse& b) { return {a.linear - b.linear, a.angular - b.angular}; }
Impulse operator*(double factor, const Impulse& a) { return {factor * a.linear, factor * a.angular}; }

}  // namespace

double push(RigidBody& body, const Impulse& impulse) {
  const Vec3d velocity = body.velocity(), spin = body.angular_velocity();
  body.add_impulse(impulse.linear, impulse.angular);
  return 0.5 * (dot(impulse.linear, velocity + body.velocity()) + dot(impulse.angular, spin + body.angular_velocity()));
}

Motion Coupling::advance(RigidBody& body, double dt) {
  body = at_t0_;
  motion_ = body.advance(dt);
  centre_of_mass_ = body.position_of_com();
  return motion_;
}

void Coupling::add(const Contact& contact, double mass, const Vec3d& place, const Vec3d& impulse, double friction, double rigidity) {
  found_.linear += impulse;
  const Vec3d arm = place - centre_of_mass_;
  found_.angular += cross(arm, impulse);

  const Vec3d& n = contact.normal;
  const auto [along, sticks] = change_of(contact, impulse, friction);
  for (std::size_t c = 0; c < 6; ++c) {
    Vector6 unit{};
    unit[c] = 1;
    const Vec3d change = first(unit) + cross(second(unit), arm);
    const double normal = dot(n, change);
    const Vec3d force = sticks ? mass * (change - ((1 - rigidity) * normal) * n) : (mass * (rigidity * normal)) * along, moment = cross(arm, force);
    for (std::size_t r = 0; r < 3; ++r) stiffness_[r][c] += force[r], stiffness_[3 + r][c] += moment[r];
  }
}

// [m/s] speed that the found impulse causes within the radius beyond that of the assumed one.
double Coupling::error(double radius) const {
  const Impulse missing = found_ - assumed_;
  return speed(at_t0_.velocity_change(missing.linear, missing.angular), radius);
}

bool Coupling::agrees(double radius, double share) const {
  const double error = this->error(radius);
  const double change = speed(at_t0_.velocity_change(found_.linear, found_.angular), radius);
  const double rounding = std::max(1e-12 * radius, 32 * std::numeric_limits<double>::epsilon() * largest_magnitude(motion_.t1.position()));  // [m]
  return !(error > share * change && motion_.dt * error > rounding);
}

Motion Coupling::correct(RigidBody& body, double radius) {
  const double error = this->error(radius);
  const bool improves = error < best_.error;
  if (++passes_ > undamped_passes && !improves) {
    damping_ *= 0.5;
    assumed_ = best_.assumed + damping_ * best_.change;
    return move(body, radius);
  }
  const Impulse change = newton_update(radius);
  if (improves) best_ = {assumed_, change, error}, damping_ = 1;
  assumed_ = assumed_ + change;
  return move(body, radius);
}

Impulse Coupling::newton_update(double radius) const {
  // moments are divided by the radius, so that all equations have the same units
  const double length = radius > 0 ? radius : 1;
  std::array<Vector6, 6> matrix{};
  for (std::size_t c = 0; c < 6; ++c) {
    Vector6 unit{};
    unit[c] = c < 3 ? 1 : length;
    const Twist twist = at_t0_.velocity_change(first(unit), second(unit));
    const Vector6 answer = product(stiffness_, {twist.velocity.x, twist.velocity.y, twist.velocity.z, twist.spin.x, twist.spin.y, twist.spin.z});
    for (std::size_t r = 0; r < 6; ++r) matrix[r][c] = (r < 3 ? answer[r] : answer[r] / length) + (r == c ? 1 : 0);
  }
  const Impulse missing = found_ - assumed_;
  const Vector6 change =
      solve(matrix, {missing.linear.x, missing.linear.y, missing.linear.z, missing.angular.x / length, missing.angular.y / length, missing.angular.z / length});
  return {first(change), length * second(change)};
}

Motion Coupling::retreat(RigidBody& body, double radius) {
  if (!(error(radius) <= best_.error)) assumed_ = best_.assumed;
  return move(body, radius);
}

Motion Coupling::move(RigidBody& body, double radius) {
  found_ = {};
  stiffness_ = {};
  const Pose before = motion_.t1;
  body = at_t0_;
  push(body, assumed_);
  motion_ = body.advance(motion_.dt);
  centre_of_mass_ = body.position_of_com();
  correction_ = travel_bound({before, motion_.t1, motion_.dt, motion_.centre}, motion_.centre, radius);
  return motion_;
}

double Coupling::finish(RigidBody& body) const {
  RigidBody pushed = at_t0_;
  return push(pushed, assumed_) + push(body, found_ - assumed_);
}

}  // namespace fccda
