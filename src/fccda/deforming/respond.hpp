/// Response to contact with a deforming surface: relocation and velocity of the points as at a rigid surface (respond/respond.hpp), and impulses on
/// the vertices of the panels in contact.
///
/// A panel of finite mass yields. With the mass m of the point, M_i of the vertices and the weights w_i of the place of contact, the velocity change Δv
/// of a point at an unyielding panel is reduced to
///   f Δv,   f = 1/(1 + m W),   W = Σ w_i²/M_i
/// so that after the impulses on both sides their relative velocity is that at an unyielding panel: a perfectly inelastic impact. The position is that
/// of relocation. Each contact is resolved by itself: where the points in contact with a vertex together are much heavier than it, the sum of
/// their impulses is too large, and a shorter step or a larger mass of the vertex is needed.
///
/// Linear momentum of points and vertices is conserved, and the angular one with the positions at t1 (vertex_impulse.hpp).
#pragma once

#include <array>
#include <span>

#include "fccda/deforming/deforming.hpp"
#include "fccda/deforming/vertex_impulse.hpp"
#include "fccda/respond/respond.hpp"

namespace fccda {

/// What respond() computes for one contact.
struct PanelImpulse {
  Resolved point;                    ///< position and velocity after contact
  Vec3d on_surface;                  ///< [N s]
  std::array<Vec3d, 3> on_vertices;  ///< [N s] of DeformingContact::place
};

/// Response of one point. `inverse_masses` [1/kg] of the three vertices, 0 for prescribed motion.
inline PanelImpulse resolved(const DeformingContact& contact, const Vec3d& position_t0, const Vec3d& velocity, double mass, double dt, double friction,
                             const std::array<double, 3>& inverse_masses) {
  const PanelPlace& place = contact.place;
  const Vec3d surface_velocity = place.displacement / dt;
  PanelImpulse out{resolved(contact.contact, position_t0, velocity, Pose(), dt, friction, [&](const Vec3d&) { return surface_velocity; }), {}, {}};
  double compliance = 0;
  for (std::size_t k = 0; k < 3; ++k) compliance += place.weights[k] * place.weights[k] * inverse_masses[k];
  const Vec3d change = (out.point.velocity - velocity) / (1 + mass * compliance);
  out.point.velocity = velocity + change;
  out.on_surface = -mass * change;
  out.on_vertices = vertex_impulses(out.on_surface, out.point.position, place.corners, place.weights);
  return out;
}

/// Relocates the points, sets their velocities, and adds the impulses on the surface to `impulses` [N s], one for each vertex of the panels that the
/// surface was made of. `inverse_mass(v)` [1/kg] of vertex v, 0 for prescribed motion. Returns the sum, with moments about the origin of the world
/// frame. Calls `report(contact, impulse)` for each contact, in order.
template <PointsInContact P, class InverseMass, class Report>
ContactSum respond(P& points, std::span<const DeformingContact> contacts, double dt, double friction, const InverseMass& inverse_mass,
                   std::span<Vec3d> impulses, Report&& report) {
  expect_friction(friction);
  ContactSum sum;
  for (const DeformingContact& contact : contacts) {
    const std::size_t i = contact.contact.point;
    std::array<double, 3> inverse_masses;
    for (std::size_t k = 0; k < 3; ++k) inverse_masses[k] = inverse_mass(static_cast<std::size_t>(contact.place.vertices[k]));
    const PanelImpulse after = resolved(contact, points.position_t0(i), points.velocity(i), points.mass(i), dt, friction, inverse_masses);
    points.set(i, after.point.position, after.point.velocity);
    for (std::size_t k = 0; k < 3; ++k) impulses[static_cast<std::size_t>(contact.place.vertices[k])] += after.on_vertices[k];
    sum += {after.on_surface, cross(after.point.position, after.on_surface), 1};
    report(contact, after.on_surface);
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
