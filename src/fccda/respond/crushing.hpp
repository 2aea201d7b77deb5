/// Crushing of the material between a point and the surface of a body in contact.
///
/// A point with a contact radius stands for a piece of material whose face is that far from it. On its way through this material the surface crushes it: the
/// normal force is a constant pressure on an area that grows linearly with the crushed depth, F = k d. The contact radius decreases by d, which never
/// decreases. Contact is rigid where the force needed is less than k d, and once the material is crushed to the point.
///
/// The force is that at the end of the step, F = k (d + Δd), so that crushing is stable for any step.
#pragma once

#include <algorithm>

namespace fccda {

/// Material of one point.
struct Crushing {
  double stiffness = 0;  ///< [N/m] k
  double depth = 0;      ///< [m] d before the step
  double left = 0;       ///< [m] that may still be crushed

  /// Change of the impulse with the motion of the body, over that of rigid contact. `mass` [kg] of the point.
  double rigidity(double mass, double dt) const {
    const double share = stiffness * dt * dt / mass;
    return share / (1 + share);
  }
};

/// What a step does to it.
struct Crushed {
  double push;   ///< [m/s] change of the velocity of the point, by the impulse
  double depth;  ///< [m] crushed
};

/// `push` [m/s]: the change due to rigid contact, at least 0. `mass` [kg] of the point.
inline Crushed crushed(const Crushing& material, double push, double mass, double dt) {
  const double rate = material.stiffness * dt / mass;  // [1/s]
  const double resisted = rate * (material.depth + push * dt) / (1 + rate * dt);
  const double depth = (push - resisted) * dt;
  if (!(depth > 0)) return {push, 0};
  return depth < material.left ? Crushed{resisted, depth} : Crushed{std::max(resisted, push - material.left / dt), material.left};
}

}  // namespace fccda
