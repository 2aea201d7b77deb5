/// Weight, buoyancy and damping of a rigid body with a closed surface in still water.
///
///   F = (ρ_w g V - m g) e_z,   M = (x_B - x) × ρ_w g V e_z                      [N], [N m] about the centre of mass x
///   U = m g (z - z_w) + ρ_w g V (z_w - z_B)                                     [J], of which F and M are the gradient
///   F_z = -c (m + a) v_z,   M = -c I (ω_x, ω_y, 0)                              while any of it is under water
///
/// V and x_B are the volume below the level z_w and its centre (mesh/submerged.hpp), at the body's current pose. The water is still: there are
/// no waves, no hydrodynamic pressure and no inflow behind moving parts. The added mass a of heave is a property of the body
/// (RigidBodyProperties::added_mass), so that contact includes it too. Docs: docs/theory/floating_bodies.md.
#pragma once

#include <optional>

#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Water without waves and currents. The functions below throw InputError if a number is not finite, or one but the level is negative, or the surface is
/// open.
struct StillWater {
  double level = 0;       ///< [m] z of the water surface
  double density = 1025;  ///< [kg/m³]
  double gravity = 9.81;  ///< [m/s²] along -z
  double damping = 0;     ///< [1/s] c of heave, roll and pitch
};

/// Hydrostatics of a body at its current pose.
struct Hydrostatics {
  double volume = 0;      ///< [m³] submerged
  Vec3d centre{};         ///< [m] of that volume, the centre of buoyancy, in the world frame
  double waterplane = 0;  ///< [m²] waterplane area of the body
  double force = 0;       ///< [N] of weight and buoyancy, upward
  Vec3d moment{};         ///< [N m] of buoyancy about the centre of mass
  double potential = 0;   ///< [J] of weight and buoyancy; 0 for a body above water with its centre of mass at the level
};

/// `surface` is that of the body, in its frame, and closed.
Hydrostatics hydrostatics(const RigidBody& body, const Surface& surface, const StillWater& water);

/// Impulse and work of water and weight on a body in a step.
struct WaterSum {
  double impulse = 0;       ///< [N s] upward
  Vec3d angular_impulse{};  ///< [N m s] about the centre of mass
  double work = 0;          ///< [J] ½ (v + v')·J + ½ (ω + ω')·L, exact for the velocities before and after
};

/// Applies the impulses of the step that begins, for the pose at t0, before the body moves (symplectic Euler, as applied loads). In free motion
/// the work is the decrease of the potential by the trapezoidal rule. Damping removes the share 1 - exp(-c dt) of the velocities, so that it is
/// stable for any step.
WaterSum apply(const StillWater& water, const Surface& surface, RigidBody& body, const Step& step);

/// The water level [m] at which the body would float at its current position and attitude: that of zero resultant force. Nothing if it is
/// heavier than the water displaced by its whole volume.
std::optional<double> level_at_rest(const RigidBody& body, const Surface& surface, const StillWater& water);

/// [m] z of the lowest point of the surface.
double keel(const RigidBody& body, const Surface& surface);

}  // namespace fccda
