/// Forces and moments on a rigid body other than contact: thrust, towing, weight.
///
/// In a step a load gives the body the impulse f F dt and, about the centre of mass, the angular impulse f (M + r × F) dt, where f is the
/// mean of its factor over the step and r the lever arm of its point at t0. The impulse is applied before the body moves (symplectic Euler).
/// Loads on constrained degrees of freedom are balanced by the reaction.
#pragma once

#include <optional>
#include <span>

#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"
#include "fccda/rigid_body/time_table.hpp"

namespace fccda {

struct AppliedLoad {
  Vec3d force{};               ///< [N] in world axes
  Vec3d moment{};              ///< [N m] about world axes
  std::optional<Vec3d> point;  ///< [m] point of application, in the body frame; the centre of mass if absent
  TimeTable factor{1};         ///< factor on force and moment
};

/// Applies the impulses of all loads over the step that begins. Returns their work [J], exact for the velocities before and after:
///   ½ (v + v')·J + ½ (ω + ω')·L.
double apply(std::span<const AppliedLoad> loads, RigidBody& body, const Step& step);

}  // namespace fccda
