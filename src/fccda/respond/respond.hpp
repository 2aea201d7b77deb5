/// What contact does to the points and to the body they struck (seed paper, section 2.2):
///
///   v̄ = (x̄ - x_t0)/dt                     eq. 8, velocity after relocation to x̄
///   J = -m (v̄ - v)                         eqs. 9 and 10 times dt, impulse on the body [N s]
///   (x̄ - x_com) × J                        its moment about the centre of mass [N m s]
///
/// The points gain what the body loses, so linear momentum is kept to rounding. The arm ends at the relocated point: a sphere
/// without friction then gets no torque, and angular momentum drifts by a share that halves with dt.
///
/// Where a point was in contact at t0 already, the push is along the normal that the surface had there, as constraint forces of SHAKE are, and the point is
/// moved along the surface for that; its arm is that of t0. The mean of the velocities before and after the push is along the surface at t0, so that the push
/// does no work on sliding but of second order in dt; along the normal at t1 it would do J u² dt/R on a place curved with the radius R.
///
/// Coulomb friction takes from the tangential velocity relative to the surface, w_t,
///   v̄ ← v̄ - min(µ J_n/m, |w_t|) w_t/|w_t|,   J_n = m (v̄ - v)·n
/// and moves x̄ along, so that eq. 8 stays true. Where the surface is in the way (another panel of a concave place, the far wall of a
/// gap), the point slides along it (SlidingSurface) and gets the change of velocity that this leaves. Its parts are projections of the
/// change wanted, so friction is never more than Coulomb's and never speeds sliding up.
#pragma once

#include <algorithm>
#include <concepts>
#include <span>

#include "base/finite.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/rigid_body.hpp"

namespace fccda {

/// What all contacts of a step did to the body.
struct ContactSum {
  Vec3d impulse{};                    ///< [N s]
  Vec3d angular_impulse_about_com{};  ///< [N m s]
  std::size_t contacts = 0;

  ContactSum& operator+=(const ContactSum& b) {
    impulse += b.impulse, angular_impulse_about_com += b.angular_impulse_about_com, contacts += b.contacts;
    return *this;
  }
};

/// Points that can be struck.
template <class P>
concept StruckPoints = requires(P& points, std::size_t i, Vec3d vector) {
  { points.position_t0(i) } -> std::convertible_to<Vec3d>;
  { points.velocity(i) } -> std::convertible_to<Vec3d>;  // [m/s] that led from t0 to t1
  { points.mass(i) } -> std::convertible_to<double>;     // [kg]
  points.set(i, vector, vector);                         // position at t1 and velocity after contact
};

/// Position at t1 and velocity of a struck point.
struct Resolved {
  Vec3d position, velocity;
};

inline Resolved resolved(const Contact& contact, const Vec3d& position_t0, const Vec3d& velocity, const Motion& motion, double friction) {
  Resolved after{contact.relocation, (contact.relocation - position_t0) / motion.dt};
  if (const double along = dot(contact.normal_t0, contact.normal); along > 0) {
    constexpr double straight = 1e-12;  // such turns are rounding
    const Vec3d push = after.position - (position_t0 + motion.dt * velocity);
    const Vec3d turn = (dot(push, contact.normal) / along) * contact.normal_t0 - push;
    if (norm(turn) > straight * norm(push)) {
      const Vec3d wanted = after.position + turn;
      after.position = contact.sliding ? contact.sliding->slide(motion.t1, after.position, wanted, contact.radius) : wanted;
      after.velocity = (after.position - position_t0) / motion.dt;
    }
  }
  if (friction == 0) return after;
  const double pushed = std::max(0.0, dot(after.velocity - velocity, contact.normal));  // J_n/m
  const Vec3d relative = after.velocity - mean_velocity(motion, after.position);
  const Vec3d sliding = relative - dot(relative, contact.normal) * contact.normal;
  const double speed = norm(sliding);
  if (speed == 0) return after;
  const Vec3d change = (std::min(friction * pushed, speed) / speed) * sliding;
  const Vec3d wanted = after.position - motion.dt * change;
  const Vec3d place = contact.sliding ? contact.sliding->slide(motion.t1, after.position, wanted, contact.radius) : wanted;
  if (place == wanted)
    after.velocity -= change;
  else
    after.velocity = (place - position_t0) / motion.dt;
  after.position = place;
  return after;
}

/// Where the impulse of a contact acts [m]: the arm of its moment leads there from the centre of mass at t1. `position`: of the point after contact.
inline Vec3d place_of_push(const Contact& contact, const Vec3d& position_t0, const Vec3d& position, const Motion& motion) {
  if (contact.normal_t0 == Vec3d{}) return position;
  return position_t0 + (motion.t1.to_world(motion.centre) - motion.t0.to_world(motion.centre));
}

/// Relocates the points and gives them their new velocities. Returns what the body, whose centre of mass is at `centre_of_mass` at t1, has to get;
/// `report(contact, impulse)` is called for each contact in order with the impulse on it [N s]. `motion` is the step the body just made.
template <StruckPoints P, class Report>
ContactSum resolve_points(P& points, std::span<const Contact> contacts, const Motion& motion, const Vec3d& centre_of_mass, double friction, Report&& report) {
  expect_friction(friction);
  ContactSum tally;
  for (const Contact& contact : contacts) {
    const std::size_t i = contact.point;
    const Vec3d start = points.position_t0(i), before = points.velocity(i);
    const Resolved after = resolved(contact, start, before, motion, friction);
    const Vec3d impulse = -points.mass(i) * (after.velocity - before);
    points.set(i, after.position, after.velocity);
    tally.impulse += impulse;
    tally.angular_impulse_about_com += cross(place_of_push(contact, start, after.position, motion) - centre_of_mass, impulse);
    ++tally.contacts;
    report(contact, impulse);
  }
  return tally;
}

/// The same, and gives the body the impulse of all of them.
template <StruckPoints P, class Report>
ContactSum respond(P& points, std::span<const Contact> contacts, const Motion& motion, RigidBody& body, double friction, Report&& report) {
  const ContactSum tally = resolve_points(points, contacts, motion, body.position_of_com(), friction, report);
  body.add_impulse(tally.impulse, tally.angular_impulse_about_com);
  return tally;
}

template <StruckPoints P>
ContactSum respond(P& points, std::span<const Contact> contacts, const Motion& motion, RigidBody& body, double friction) {
  return respond(points, contacts, motion, body, friction, [](const Contact&, const Vec3d&) {});
}

}  // namespace fccda
