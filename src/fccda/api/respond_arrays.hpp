/// The response as a plain call: struck points are put back on the surface, get their new velocities, and the body their impulse
/// (respond/respond.hpp has the equations).
#pragma once

#include <span>

#include "fccda/api/vectors.hpp"
#include "fccda/respond/respond.hpp"

namespace fccda {

using Masses = Numbers;

/// The solver's arrays, in point order.
struct PointArrays {
  ConstVectors x_t0;  ///< [m]
  Vectors x_t1;       ///< [m] struck points are put back on the surface
  Vectors velocity;   ///< [m/s] that led from x_t0 to x_t1; of struck points the one that leads to where they are put back
  Masses mass;        ///< [kg] one for all, or one for each
};

/// Changes the points that struck and the body, and returns what the body got. `friction`: Coulomb's coefficient, 0 for none. Throws
/// InputError where the arrays differ in length, the step of the motion has no duration, the friction is negative or not finite, or the
/// mass or velocity of a point that struck is.
ContactSum respond(std::span<const Contact> contacts, const Motion& motion, RigidBody& body, const PointArrays& points, double friction = 0);

/// The same but for the body, which stays as it is: where its impulses come from several places, as from the points of each rank of an MPI
/// program or from several sets of points, the caller adds the tallies up and gives the body their sum, once:
///   body.add_impulse(tally.impulse, tally.angular_impulse_about_com);
ContactSum respond_without_body(std::span<const Contact> contacts, const Motion& motion, const RigidBody& body, const PointArrays& points, double friction = 0);

}  // namespace fccda
