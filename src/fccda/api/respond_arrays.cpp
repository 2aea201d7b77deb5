#include "fccda/api/respond_arrays.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/api/contact_arrays.hpp"

namespace fccda {

void expect_equally_long(const PointArrays& points) {
  const std::size_t count = points.x_t0.size();
  if (points.x_t1.size() == count && points.velocity.size() == count && points.mass.are_for(count)) return;
  throw InputError("contact: the arrays of positions, velocities and masses are not equally long (" + std::to_string(count) + " positions at t0, " +
                   std::to_string(points.x_t1.size()) + " at t1, " + std::to_string(points.velocity.size()) + " velocities); give each for every point.");
}

void expect_usable_point(const PointArrays& points, std::size_t point) {
  const std::size_t count = points.x_t0.size();
  if (point >= count)
    throw InputError("contact: there is a contact of point " + std::to_string(point) + ", but there are only " + std::to_string(count) + " points.");
  const double mass = points.mass[point];
  if (!(mass >= 0 && std::isfinite(mass)))
    throw InputError("contact: the mass of point " + std::to_string(point) + " is " + in_words(mass) + " kg, but it must be a finite number of at least 0.");
  const auto expect_sound = [&](const Vec3d& vector, const std::string& what) {
    if (is_finite(vector)) return;
    throw RunError("contact: the " + what + " of point " + std::to_string(point) + " is " + in_words(vector) +
                   ", which is not finite; the solver has become unstable, use a shorter step.");
  };
  expect_sound(points.velocity[point], "velocity");
  expect_sound(points.x_t0[point], "position at t0");
}

void expect_later(std::size_t point, std::size_t point_before) {
  if (point > point_before) return;
  throw InputError("contact: a contact of point " + std::to_string(point) + " follows one of point " + std::to_string(point_before) +
                   ", but each point may have one contact only, in ascending order; respond to the contacts of each detector by themselves.");
}

namespace {

void expect_usable(std::span<const Contact> contacts, const Motion& motion, const PointArrays& points, double friction) {
  expect_equally_long(points);
  if (!(motion.dt > 0)) throw InputError("contact: the step of the motion has no duration, but velocities need one; set Motion::dt.");
  expect_usable(motion);
  expect_friction(friction);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    expect_usable_point(points, contacts[c].point);
    if (c > 0) expect_later(contacts[c].point, contacts[c - 1].point);
  }
}

}  // namespace

ContactSum respond(std::span<const Contact> contacts, const Motion& motion, RigidBody& body, const PointArrays& points, double friction) {
  expect_usable(contacts, motion, points, friction);
  ContactArrays resolved{points};
  return respond(resolved, contacts, motion, body, friction);
}

ContactSum respond_without_body(std::span<const Contact> contacts, const Motion& motion, const RigidBody& body, const PointArrays& points, double friction) {
  RigidBody stand_in = body;
  return respond(contacts, motion, stand_in, points, friction);
}

}  // namespace fccda
