#include "fccda/api/respond_arrays.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

/// The arrays that respond() modifies.
struct ContactArrays {
  const PointArrays& arrays;

  Vec3d position_t0(std::size_t i) const { return arrays.x_t0[i]; }
  Vec3d velocity(std::size_t i) const { return arrays.velocity[i]; }
  double mass(std::size_t i) const { return arrays.mass[i]; }
  void set(std::size_t i, const Vec3d& position, const Vec3d& velocity) const {
    arrays.x_t1.set(i, position);
    arrays.velocity.set(i, velocity);
  }
};

void expect_usable(std::span<const Contact> contacts, const Motion& motion, const PointArrays& points, double friction) {
  const std::size_t count = points.x_t0.size();
  if (points.x_t1.size() != count || points.velocity.size() != count || !points.mass.are_for(count))
    throw InputError("contact: the arrays of positions, velocities and masses are not equally long (" + std::to_string(count) + " positions at t0, " +
                     std::to_string(points.x_t1.size()) + " at t1, " + std::to_string(points.velocity.size()) + " velocities); give each for every point.");
  if (!(motion.dt > 0)) throw InputError("contact: the step of the motion has no duration, but velocities need one; set Motion::dt.");
  expect_usable(motion);
  expect_friction(friction);
  for (const Contact& contact : contacts) {
    if (contact.point >= count)
      throw InputError("contact: there is a contact of point " + std::to_string(contact.point) + ", but there are only " + std::to_string(count) + " points.");
    const double mass = points.mass[contact.point];
    if (!(mass >= 0 && std::isfinite(mass)))
      throw InputError("contact: the mass of point " + std::to_string(contact.point) + " is " + in_words(mass) +
                       " kg, but it must be a finite number of at least 0.");
    expect_finite(points.velocity[contact.point], "contact: the velocity of point " + std::to_string(contact.point));
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
