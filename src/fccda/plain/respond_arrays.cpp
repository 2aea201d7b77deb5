#include "fccda/plain/respond_arrays.hpp"

#include <string>

#include "fccda/core/error.hpp"

namespace fccda {

namespace {

/// Arrays as what respond() changes.
struct StruckArrays {
  const PointArrays& arrays;

  Vec3d position_t0(std::size_t i) const { return arrays.x_t0[i]; }
  Vec3d velocity(std::size_t i) const { return arrays.velocity[i]; }
  double mass(std::size_t i) const { return arrays.mass[i]; }
  void set(std::size_t i, const Vec3d& position, const Vec3d& velocity) const {
    arrays.x_t1.set(i, position);
    arrays.velocity.set(i, velocity);
  }
};

}  // namespace

Tally respond(std::span<const Contact> contacts, const Motion& motion, RigidBody& body, const PointArrays& points, double friction) {
  const std::size_t count = points.x_t0.size();
  if (points.x_t1.size() != count || points.velocity.size() != count || !points.mass.are_for(count))
    throw InputError("contact: the arrays of positions, velocities and masses are not equally long (" + std::to_string(count) + " positions at t0, " +
                     std::to_string(points.x_t1.size()) + " at t1, " + std::to_string(points.velocity.size()) + " velocities); give each for every point.");
  if (!(motion.dt > 0)) throw InputError("contact: the step of the motion has no duration, but velocities need one; set Motion::dt.");
  StruckArrays struck{points};
  return respond(struck, contacts, motion, body, friction);
}

}  // namespace fccda
