/// Weight, and what still water does to a rigid body with a closed surface.
///
///   F = (ρ_w g V - m g) e_z,   M = (x_B - x) × ρ_w g V e_z                      [N], [N m] about the centre of mass x
///   U = m g (z - z_w) + ρ_w g V (z_w - z_B)                                     [J], of which F and M are the gradient
///   F_z = -c (m + a) v_z,   M = -c I (ω_x, ω_y, 0)                              while any of it is under water
///
/// V and x_B are the volume under the level z_w and its centre (surface/submerged.hpp), where the body is now. The water lies still: there are no
/// waves and no pressure from speed, and it does not fall in behind anything. The mass a of the water that comes along with heave is a
/// property of the body (RigidBodyProperties::added_mass), so that contact feels it too. Docs: docs/theory/floating_bodies.md.
#pragma once

#include <optional>

#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct StillWater {
  double level = 0;       ///< [m] z of its surface
  double density = 1025;  ///< [kg/m³]
  double gravity = 9.81;  ///< [m/s²] along -z
  double damping = 0;     ///< [1/s] c of heave, roll and pitch
};

/// A body in still water, where it is now.
struct Hydrostatics {
  double volume = 0;      ///< [m³] under water
  Vec3d centre{};         ///< [m] of that volume, the centre of buoyancy, in the world
  double waterplane = 0;  ///< [m²] of the water's surface that the body takes
  double force = 0;       ///< [N] of weight and buoyancy, upward
  Vec3d moment{};         ///< [N m] of buoyancy about the centre of mass
  double potential = 0;   ///< [J] of weight and buoyancy; 0 for a body above water whose centre of mass is at the level
};

/// The surface is that of the body, in its frame, and closed.
Hydrostatics hydrostatics(const RigidBody& body, const Surface& surface, const StillWater& water);

/// What water and weight gave a body in a step.
struct WaterSum {
  double impulse = 0;       ///< [N s] upward
  Vec3d angular_impulse{};  ///< [N m s] about the centre of mass
  double work = 0;          ///< [J] ½ (v + v')·J + ½ (ω + ω')·L, exact for the velocities before and after
};

/// Gives the body the impulses of the step that begins, from where it is at t0, before it moves (symplectic Euler, as applied loads). In free
/// motion the work is the decrease of the potential by the trapezoidal rule. Damping takes the share 1 - exp(-c dt) of the velocities, so
/// that no step is too long for it.
WaterSum apply(const StillWater& water, const Surface& surface, RigidBody& body, const Step& step);

/// The level [m] at which the body would float where it is and as it is turned now: that of no resultant force. Nothing where it is
/// heavier than the water that its whole volume displaces.
std::optional<double> level_at_rest(const RigidBody& body, const Surface& surface, const StillWater& water);

/// [m] z of the lowest place of the surface.
double keel(const RigidBody& body, const Surface& surface);

}  // namespace fccda
