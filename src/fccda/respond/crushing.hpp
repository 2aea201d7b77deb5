/// Crushing of the material of a point by the surface of a body in contact.
///
/// A point with a contact radius r stands for a piece of material as thick as the ball of this radius. On its way through the piece the surface crushes it: a
/// constant pressure acts on the cross-section of the whole ball at the crushed depth d, scaled so that the work of the force is the pressure times the volume
/// of the piece,
///
///   F(d) = 4 F_m (d/2r) (1 - d/2r),    0 <= d <= 2r;  d never decreases
///
/// What is left of the ball is the ball of the radius r - d/2 that touches its rear side. Contact is rigid where the force needed is less than F(d), and once
/// the piece is crushed.
///
/// The force is that at the end of the step, F(d + Δd), so that crushing is stable for any step.
#pragma once

#include <cmath>

namespace fccda {

/// Material of one point.
struct Crushing {
  double largest_force = 0;  ///< [N] F_m, at half of the thickness
  double thickness = 0;      ///< [m] 2r of the whole piece
  double depth = 0;          ///< [m] d before the step
  double left = 0;           ///< [m] that may still be crushed

  /// [N] at a depth [m].
  double force(double d) const { return 4 * largest_force * (d / thickness) * (1 - d / thickness); }

  /// Change of the impulse with the motion of the body, over that of rigid contact. `mass` [kg] of the point.
  double rigidity(double mass, double dt) const {
    const double slope = 4 * largest_force / thickness * (1 - 2 * depth / thickness);  // [N/m]
    const double share = slope * dt * dt / mass;
    return share > -0.5 ? share / (1 + share) : 1;  // where the force falls faster than inertia allows, the depth is that of the body
  }
};

/// What a step does to it.
struct Crushed {
  double push;   ///< [m/s] change of the velocity of the point, by the impulse
  double depth;  ///< [m] crushed
};

/// `push` [m/s]: the change due to rigid contact, at least 0. `mass` [kg] of the point.
inline Crushed crushed(const Crushing& material, double push, double mass, double dt) {
  if (!(material.left > 0)) return {push, 0};
  // (d + Δd) = d + push Δt - F(d + Δd) Δt²/m, a quadratic equation for (d + Δd)/2r
  const double rate = 4 * material.largest_force * dt * dt / (mass * material.thickness);  // [-]
  const double without = (material.depth + push * dt) / material.thickness, discriminant = (1 + rate) * (1 + rate) - 4 * rate * without;
  const double all = material.depth + material.left;
  const auto reached = [&] {
    if (discriminant < 0) return all;
    const double sum = 1 + rate + std::sqrt(discriminant);
    if (2 * rate * material.depth > sum * material.thickness) return all;  // d is beyond both solutions
    return std::fmin(all, material.thickness * (2 * without / sum));
  };
  const double depth = reached() - material.depth;
  if (!(depth > 0)) return {push, 0};
  return {std::fmax(0.0, push - depth / dt), depth};
}

}  // namespace fccda
