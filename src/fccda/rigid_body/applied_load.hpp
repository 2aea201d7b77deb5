/// Forces and moments on a rigid body other than contact: thrust, towing, drag, weight.
///
/// In a step a load gives the body the impulse f g F dt and, about the centre of mass, the angular impulse f g (M + r × F) dt, where f is the
/// mean of its factor over the step, g its speed factor at t0, and r the lever arm of its point at t0. The impulse is applied before the body moves
/// (symplectic Euler). Loads on constrained degrees of freedom are balanced by the reaction.
#pragma once

#include <optional>
#include <span>

#include "fccda/rigid_body/piecewise_linear.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"

namespace fccda {

struct AppliedLoad {
  Vec3d force{};                    ///< [N] in world axes
  Vec3d moment{};                   ///< [N m] about world axes
  std::optional<Vec3d> point;       ///< [m] point of application, in the body frame; the centre of mass if absent
  PiecewiseLinear factor{1};        ///< of time [s]: factor on force and moment
  PiecewiseLinear speed_factor{1};  ///< of the speed [m/s] of the centre of mass along the force: a further factor
};

/// Applies the impulses of all loads over the step that begins. Returns their work [J], exact for the velocities before and after:
///   ½ (v + v')·J + ½ (ω + ω')·L.
double apply(std::span<const AppliedLoad> loads, RigidBody& body, const Step& step);

}  // namespace fccda
