/// How the impulse of a contact changes with the velocity of the surface there, for implicit coupling (respond/coupling.hpp).
#pragma once

#include "base/vec3.hpp"
#include "fccda/detect/contact.hpp"

namespace fccda {

/// δJ = -m δv of a point that sticks, and -m (n·δv) along of one that slides or whose impulse acts along the normal of t0.
struct ImpulseChange {
  Vec3d along;          ///< [-] n, or Δv/Δv·n
  bool sticks = false;  ///< it moves with the surface
};

/// `impulse` [N s]: on the surface.
inline ImpulseChange change_of(const Contact& contact, const Vec3d& impulse, double friction) {
  const Vec3d& n = contact.normal;
  const double pressed = -dot(impulse, n);
  if (!(pressed > 0 && (friction > 0 || contact.normal_t0 != Vec3d{}))) return {n};
  constexpr double rounding = 1e-9;
  return {(-1 / pressed) * impulse, friction > 0 && norm(impulse + pressed * n) < (1 - rounding) * friction * pressed};
}

}  // namespace fccda
