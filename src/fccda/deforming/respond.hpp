/// Response to contact with a deforming surface: relocation and velocity of the points as at a rigid surface (respond/respond.hpp), and impulses on
/// the vertices of the panels in contact.
///
/// Panels of finite mass yield. All contacts of the step are resolved together as one perfectly inelastic impact: impact_shares.hpp reduces the change of
/// each point's velocity so that, after the impulses on both sides, the velocities of point and panel differ along the normal as at an unyielding panel.
/// Many points that are heavier than the vertices they meet then leave with them, and nothing gains energy. Positions are those of relocation.
///
/// Linear momentum of points and vertices is conserved, and the angular one with the positions at t1 (vertex_impulse.hpp).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "fccda/deforming/deforming.hpp"
#include "fccda/deforming/impact_shares.hpp"
#include "fccda/deforming/vertex_impulse.hpp"
#include "fccda/respond/respond.hpp"

namespace fccda {

/// What respond() computes for one contact.
struct PanelImpulse {
  Resolved point;                    ///< position and velocity after contact
  Vec3d on_surface;                  ///< [N s]
  std::array<Vec3d, 3> on_vertices;  ///< [N s] of DeformingContact::place
};

/// The impulses on panel and vertices of a point of `mass` [kg] whose velocity changes from `before` [m/s] to that of `after`.
inline PanelImpulse panel_impulse(const DeformingContact& contact, double mass, const Vec3d& before, const Resolved& after) {
  const Vec3d on_surface = -mass * (after.velocity - before);
  return {after, on_surface, vertex_impulses(on_surface, after.position, contact.place.corners, contact.place.weights)};
}

/// Response of one point to a panel that does not yield.
inline PanelImpulse resolved(const DeformingContact& contact, const Vec3d& position_t0, const Vec3d& velocity, double mass, double dt, double friction) {
  const Vec3d surface_velocity = contact.place.displacement / dt;
  return panel_impulse(contact, mass, velocity,
                       resolved(contact.contact, position_t0, velocity, Pose(), dt, friction, [&](const Vec3d&) { return surface_velocity; }));
}

/// What impact_shares() needs of one contact, besides masses of vertices. `frictionless` [m/s]: velocity of the point after contact without friction.
inline PanelImpact panel_impact(const DeformingContact& contact, double mass, const Vec3d& before, const Vec3d& frictionless, const Resolved& after) {
  const auto part = [&](const Vec3d& change) {
    const double speed = norm(change);
    if (!(speed > 0)) return PanelImpact::Part();
    const Vec3d direction = change / speed;
    return PanelImpact::Part{speed, direction, vertex_impulses(direction, after.position, contact.place.corners, contact.place.weights)};
  };
  const Vec3d push = frictionless - before;
  return {.vertices = contact.place.vertices,
          .mass = mass,
          .is_pushed = dot(push, contact.contact.normal) > 0,
          .push = part(push),
          .friction = part(after.velocity - frictionless)};
}

/// Relocates the points, sets their velocities, and adds the impulses on the surface to `impulses` [N s], one for each vertex of the panels that the
/// surface was made of. `inverse_mass(v)` [1/kg] of vertex v, 0 for prescribed motion. Returns the sum, with moments about the origin of the world
/// frame. Calls `report(contact, impulse)` for each contact, in order. Throws InputError, and changes nothing, if an impulse is not finite.
template <PointsInContact P, class InverseMass, class Report>
ContactSum respond(P& points, std::span<const DeformingContact> contacts, double dt, double friction, const InverseMass& inverse_mass,
                   std::span<Vec3d> impulses, Report&& report) {
  expect_friction(friction);
  std::vector<Resolved> after;
  std::vector<PanelImpact> impacts;
  for (const DeformingContact& contact : contacts) {
    const std::size_t i = contact.contact.point;
    const Vec3d before = points.velocity(i);
    const Resolved frictionless = resolved(contact, points.position_t0(i), before, points.mass(i), dt, 0).point;
    after.push_back(friction > 0 ? resolved(contact, points.position_t0(i), before, points.mass(i), dt, friction).point : frictionless);
    PanelImpact& impact = impacts.emplace_back(panel_impact(contact, points.mass(i), before, frictionless.velocity, after.back()));
    for (std::size_t k = 0; k < 3; ++k) impact.inverse_masses[k] = inverse_mass(static_cast<std::size_t>(contact.place.vertices[k]));
  }
  const std::vector<ImpactShare> shares = impact_shares(impacts);
  ContactSum sum;
  std::vector<PanelImpulse> all;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const DeformingContact& contact = contacts[c];
    const Vec3d before = points.velocity(contact.contact.point);
    const PanelImpact::Part &push = impacts[c].push, &drag = impacts[c].friction;
    after[c].velocity = before + (shares[c].push * push.change) * push.direction + (shares[c].friction * drag.change) * drag.direction;
    const PanelImpulse& impulse = all.emplace_back(panel_impulse(contact, impacts[c].mass, before, after[c]));
    for (const Vec3d& on_vertex : impulse.on_vertices)
      if (!is_finite(on_vertex)) expect_finite(on_vertex, "contact: the impulse of point " + std::to_string(contact.contact.point) + " on a vertex");
    sum += {impulse.on_surface, cross(after[c].position, impulse.on_surface), 1};
  }
  // before anything changes
  expect_finite(sum.impulse, "contact: the sum of the impulses on the surface");
  expect_finite(sum.angular_impulse, "contact: the sum of the angular impulses on the surface");
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const DeformingContact& contact = contacts[c];
    points.set(contact.contact.point, after[c].position, after[c].velocity);
    for (std::size_t k = 0; k < 3; ++k) impulses[static_cast<std::size_t>(contact.place.vertices[k])] += all[c].on_vertices[k];
    report(contact, all[c].on_surface);
  }
  return sum;
}

/// The same without a report of single contacts.
template <PointsInContact P, class InverseMass>
ContactSum respond(P& points, std::span<const DeformingContact> contacts, double dt, double friction, const InverseMass& inverse_mass,
                   std::span<Vec3d> impulses) {
  return respond(points, contacts, dt, friction, inverse_mass, impulses, [](const DeformingContact&, const Vec3d&) {});
}

}  // namespace fccda
