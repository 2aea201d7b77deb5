/// Contact response: impulses and relocation of the points, and impulse on the body in contact (Zhang et al., section 2.2):
///
///   v̄ = (x̄ - x_t0)/dt                     eq. 8, velocity after relocation to x̄
///   J = -m (v̄ - v)                         eqs. 9 and 10 times dt, impulse on the body [N s]
///   (x̄ - x_com) × J                        its moment about the centre of mass [N m s]
///
/// Impulses on points and body are equal and opposite, so that linear momentum is conserved to rounding. The lever arm ends at the relocated
/// point: a frictionless sphere then gets no torque, and the drift of angular momentum is proportional to dt.
///
/// If a point was in contact at t0 already, its impulse acts along the surface normal at t0, like the constraint forces of SHAKE. The relocated
/// point is shifted along the surface accordingly; its lever arm is that of t0. The mean of the velocities before and after the impulse is
/// tangential to the surface at t0, so that the work on a sliding point is of second order in dt. Along the normal at t1 it would be J u² dt/R on
/// a surface with the radius of curvature R.
///
/// Coulomb friction reduces the tangential velocity relative to the surface, w_t,
///   v̄ ← v̄ - min(µ J_n/m, |w_t|) w_t/|w_t|,   J_n = m (v̄ - v)·n
/// and shifts x̄ accordingly, so that eq. 8 still applies. If the surface obstructs this shift (another panel of a concave region, the
/// opposite wall of a gap), the point slides along it (SlidingSurface) and its velocity changes by the remaining shift. As a projection of
/// the unobstructed change, friction never exceeds Coulomb's limit and never accelerates sliding.
///
/// Coordinates in single precision are rounded by far more than those in double precision. Contact is therefore tested at an offset o nearer than the
/// contact radius, and relocated to o beyond it (Contact::offset). A point at rest sinks from one to the other, and eq. 8 would take its way back for a
/// velocity of 2 o/dt. The velocity away from the surface is reduced by as much, but not below that of the surface:
///   v̄ ← v̄ - min(2 o/dt, w_n, J_n/m) n,   w_n = (v̄ - velocity of the surface)·n > 0
///
/// Points may have material that the body crushes (crushing.hpp): they are then relocated by less, and the ball that is left of them is smaller.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "base/finite.hpp"
#include "base/parallel_throwing.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/respond/crushing.hpp"
#include "fccda/rigid_body/rigid_body.hpp"

namespace fccda {

/// Sum of the contacts of a step, on the body.
struct ContactSum {
  Vec3d impulse{};  ///< [N s]
  /// [N m s] at a rigid body about the centre of mass of the RigidBody that respond() was given, where that is now; at a deforming surface about the
  /// origin of the world frame. For a body that the program moves itself give respond() one with its centre of mass at Motion::centre and its pose at t1;
  /// fccda_respond() in C without a body does so.
  Vec3d angular_impulse{};
  std::size_t contacts = 0;  ///< number of contacts

  /// Adds the sum of other contacts.
  ContactSum& operator+=(const ContactSum& b) {
    impulse += b.impulse, angular_impulse += b.angular_impulse, contacts += b.contacts;
    return *this;
  }
};

/// Requirements on points in contact. All but set() are called by several threads at once.
template <class P>
concept PointsInContact = requires(P& points, std::size_t i, Vec3d vector) {
  { points.position_t0(i) } -> std::convertible_to<Vec3d>;
  { points.velocity(i) } -> std::convertible_to<Vec3d>;  // [m/s] between t0 and t1
  { points.mass(i) } -> std::convertible_to<double>;     // [kg]
  points.set(i, vector, vector);                         // position at t1 and velocity after contact
};

/// Points of individual radii (PointsOfOwnRadius) whose material is crushed. Their positions are those of the ball that is left of it, `offset` from the
/// point to which its mass belongs. crush() shortens the radius by half of the depth, and shifts the ball by as much along `direction`, of unit length.
template <class P>
concept CrushablePoints = PointsInContact<P> && requires(P& points, std::size_t i, double depth, Vec3d direction) {
  { points.crushing(i) } -> std::convertible_to<Crushing>;
  { points.offset(i) } -> std::convertible_to<Vec3d>;  // [m]
  points.crush(i, depth, direction);                   // [m], after set()
};

/// Position at t1 and velocity of a point after contact.
struct Resolved {
  Vec3d position, velocity;  ///< [m], [m/s]
  double crushed = 0;        ///< [m] depth
  Vec3d direction{};         ///< of unit length, in which it was crushed
};

/// Position reached on the way from `from` to `wanted` along the surface, at `pose` [m]: `wanted` unless the surface obstructs the point of that radius [m].
inline Vec3d slid(const Contact& contact, const Pose& pose, const Vec3d& from, const Vec3d& wanted, double radius) {
  return contact.sliding ? contact.sliding->slide(pose, from, wanted, radius) : wanted;
}

/// Part of the velocity after relocation [m/s] that is the way across the offset of single precision, and no motion (above). `velocity`: before.
template <class SurfaceVelocity>
Vec3d velocity_across_offset(const Contact& contact, const Vec3d& velocity, const Resolved& after, double dt, const SurfaceVelocity& surface_velocity) {
  const double separating = dot(after.velocity - surface_velocity(after.position), contact.normal), pushed = dot(after.velocity - velocity, contact.normal);
  return std::max(0.0, std::min({2 * contact.offset / dt, separating, pushed})) * contact.normal;
}

/// Response of one point: relocation and friction. `pose`: of the surface at t1; `surface_velocity(x)` [m/s]: mean over the step of the surface's
/// material point that is at x at t1. `limit(push)`: Crushed, for a velocity change of `push` in rigid contact.
template <class SurfaceVelocity, class Limit>
Resolved resolved(const Contact& contact, const Vec3d& position_t0, const Vec3d& velocity, const Pose& pose, double dt, double friction,
                  const SurfaceVelocity& surface_velocity, const Limit& limit) {
  Resolved after{contact.relocation, (contact.relocation - position_t0) / dt};
  if (const double along = dot(contact.normal_t0, contact.normal); along > 0) {
    constexpr double straight = 1e-12;  // smaller rotations are rounding
    const Vec3d push = after.position - (position_t0 + dt * velocity);
    const Vec3d turn = (dot(push, contact.normal) / along) * contact.normal_t0 - push;
    if (norm(turn) > straight * norm(push)) {
      after.position = slid(contact, pose, after.position, after.position + turn, contact.radius);
      after.velocity = (after.position - position_t0) / dt;
    }
  }
  Vec3d across{};
  if (contact.offset > 0) {
    across = velocity_across_offset(contact, velocity, after, dt, surface_velocity);
    after.velocity -= across;
  }
  const Vec3d change = after.velocity - velocity;
  double pushed = std::max(0.0, dot(change, contact.normal));  // J_n/m
  Vec3d shift{};                                               // [m] of the ball by crushing
  double radius = contact.radius;
  // The whole relocation is shortened, by the depth: in a corner the ball that is left then remains clear of all walls.
  if (const Crushed less = limit(norm(change)); less.depth > 0) {
    const double share = less.push / norm(change);
    after.velocity = velocity + share * change;
    after.position = position_t0 + dt * after.velocity;
    after.crushed = less.depth;
    after.direction = change / norm(change);
    shift = (less.depth / 2) * after.direction;
    radius = std::max(0.0, radius - less.depth / 2);
    pushed *= share;
  }
  if (friction == 0) return after;
  const Vec3d relative = after.velocity - surface_velocity(after.position);
  const Vec3d sliding = relative - dot(relative, contact.normal) * contact.normal;
  const double speed = norm(sliding);
  if (speed == 0) return after;
  const Vec3d braked = (std::min(friction * pushed, speed) / speed) * sliding;
  const Vec3d wanted = after.position + shift - dt * braked, place = slid(contact, pose, after.position + shift, wanted, radius);
  if (place == wanted) {
    after.position -= dt * braked;
    after.velocity -= braked;
  } else {
    after.position = place - shift;
    after.velocity = (after.position - position_t0) / dt;
    if (contact.offset > 0) after.velocity -= across;
  }
  return after;
}

/// The same for material that is not crushed.
template <class SurfaceVelocity>
Resolved resolved(const Contact& contact, const Vec3d& position_t0, const Vec3d& velocity, const Pose& pose, double dt, double friction,
                  const SurfaceVelocity& surface_velocity) {
  return resolved(contact, position_t0, velocity, pose, dt, friction, surface_velocity, [](double push) { return Crushed{push, 0}; });
}

/// The same for a rigid body.
inline Resolved resolved(const Contact& contact, const Vec3d& position_t0, const Vec3d& velocity, const Motion& motion, double friction) {
  return resolved(contact, position_t0, velocity, motion.t1, motion.dt, friction, [&](const Vec3d& x) { return mean_velocity(motion, x); });
}

/// The same for one of the points, whose material may be crushed.
template <PointsInContact P>
Resolved resolved(const Contact& contact, P& points, const Motion& motion, double friction) {
  const std::size_t i = contact.point;
  if constexpr (CrushablePoints<P>)
    return resolved(
        contact, points.position_t0(i), points.velocity(i), motion.t1, motion.dt, friction, [&](const Vec3d& x) { return mean_velocity(motion, x); },
        [&](double push) { return crushed(points.crushing(i), push, points.mass(i), motion.dt); });
  else
    return resolved(contact, points.position_t0(i), points.velocity(i), motion, friction);
}

/// Point of application of a contact impulse [m]: end of its lever arm from the centre of mass at t1. `position`: of the point after contact.
inline Vec3d point_of_application(const Contact& contact, const Vec3d& position_t0, const Vec3d& position, const Motion& motion) {
  if (contact.normal_t0 == Vec3d{}) return position;
  return position_t0 + (motion.t1.to_world(motion.centre) - motion.t0.to_world(motion.centre));
}

/// Minimum number of contacts for a parallel loop: fewer are resolved before other threads have woken (25 µs).
inline constexpr std::size_t contacts_worth_threads = 64;

/// Relocates the points and sets their velocities. Returns the impulse due to the body, whose centre of mass is at `centre_of_mass` at t1.
/// Calls `report(contact, impulse)` for each contact, in order, with the impulse on the body [N s]. `motion`: of the body in this step.
/// `contacts`: of a detector, which finds at most one for each point. Throws InputError, and changes nothing, if the impulses are not finite.
template <PointsInContact P, class Report>
ContactSum resolve_points(P& points, std::span<const Contact> contacts, const Motion& motion, const Vec3d& centre_of_mass, double friction, Report&& report) {
  expect_friction(friction);
  std::vector<Resolved> all(contacts.size());
  const auto resolve = [&](std::size_t k) { all[k] = resolved(contacts[k], points, motion, friction); };
  if (contacts.size() < contacts_worth_threads)
    for (std::size_t k = 0; k < contacts.size(); ++k) resolve(k);
  else
    parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(contacts.size()), [&](std::ptrdiff_t k) { resolve(static_cast<std::size_t>(k)); });
  ContactSum sum;
  const auto impulse_of = [&](std::size_t k) { return -points.mass(contacts[k].point) * (all[k].velocity - points.velocity(contacts[k].point)); };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3d impulse = impulse_of(k);
    Vec3d place = point_of_application(contacts[k], points.position_t0(contacts[k].point), all[k].position, motion);
    if constexpr (CrushablePoints<P>) place -= points.offset(contacts[k].point);
    sum.impulse += impulse;
    sum.angular_impulse += cross(place - centre_of_mass, impulse);
    ++sum.contacts;
  }
  // before anything changes
  expect_finite(sum.impulse, "contact: the sum of the impulses on the body");
  expect_finite(sum.angular_impulse, "contact: the sum of the angular impulses on the body");
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3d impulse = impulse_of(k);
    points.set(contacts[k].point, all[k].position, all[k].velocity);
    if constexpr (CrushablePoints<P>)
      if (all[k].crushed > 0) points.crush(contacts[k].point, all[k].crushed, all[k].direction);
    report(contacts[k], impulse);
  }
  return sum;
}

/// The same, and applies the impulse to the body.
template <PointsInContact P, class Report>
ContactSum respond(P& points, std::span<const Contact> contacts, const Motion& motion, RigidBody& body, double friction, Report&& report) {
  const ContactSum sum = resolve_points(points, contacts, motion, body.position_of_com(), friction, report);
  body.add_impulse(sum.impulse, sum.angular_impulse);
  return sum;
}

/// The same without a report of single contacts.
template <PointsInContact P>
ContactSum respond(P& points, std::span<const Contact> contacts, const Motion& motion, RigidBody& body, double friction) {
  return respond(points, contacts, motion, body, friction, [](const Contact&, const Vec3d&) {});
}

}  // namespace fccda
