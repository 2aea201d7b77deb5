/// Contact response as a plain function call: points in contact are relocated to the surface and get new velocities; the body gets their
/// impulse (equations in respond/respond.hpp).
#pragma once

#include <span>

#include "fccda/api/vectors.hpp"
#include "fccda/respond/respond.hpp"

namespace fccda {

/// Masses of the points [kg].
using Masses = Numbers;

/// The solver's arrays, in point order.
struct PointArrays {
  ConstVectors x_t0;  ///< [m]
  Vectors x_t1;       ///< [m] points in contact are relocated to the surface
  Vectors velocity;   ///< [m/s] from x_t0 to x_t1; for points in contact, the velocity to the relocated position
  Masses mass;        ///< [kg] one for all, or one for each
};

/// Modifies the points in contact and the body, and returns what the body received. `friction`: the coefficient of Coulomb friction, 0 for
/// none. Throws InputError if the arrays differ in length, the step of the motion has no duration, the friction is negative or not finite, or the
/// contacts are not in ascending order of their points, one for each: those of several detectors are responded to one after the other.
/// The same applies if the mass of a point in contact is negative or not finite. Throws RunError if its velocity or position at t0 is not finite.
/// Nothing is changed then.
ContactSum respond(std::span<const Contact> contacts, const Motion& motion, RigidBody& body, const PointArrays& points, double friction = 0);

/// The same without a change of the body. If its impulses come from several sources, such as the ranks of an MPI program or several sets of
/// points, the caller sums the results and applies the total once:
///   body.add_impulse(sum.impulse, sum.angular_impulse);
ContactSum respond_without_body(std::span<const Contact> contacts, const Motion& motion, const RigidBody& body, const PointArrays& points, double friction = 0);

}  // namespace fccda
