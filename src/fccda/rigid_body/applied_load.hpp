/// Forces and moments that act on a rigid body besides contact: thrust, towing, weight.
///
/// In a step a load gives the body the impulse f F dt and, about the centre of mass, the angular impulse f (M + r × F) dt, where f is the
/// mean of its factor over the step and r the arm of its point, where the body is at t0. The body takes it before it moves (symplectic
/// Euler). What acts on held degrees of freedom is taken by what holds them.
#pragma once

#include <optional>
#include <span>

#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"
#include "fccda/rigid_body/time_table.hpp"

namespace fccda {

struct AppliedLoad {
  Vec3d force{};               ///< [N] along the axes of the world
  Vec3d moment{};              ///< [N m] about the axes of the world
  std::optional<Vec3d> point;  ///< [m] where the force acts, in the body frame; the centre of mass where absent
  TimeTable factor{1};         ///< multiplies force and moment
};

/// Gives the body the impulses of all loads over the step that begins. Returns their work [J], exact for the velocities before and after:
///   ½ (v + v')·J + ½ (ω + ω')·L.
double apply(std::span<const AppliedLoad> loads, RigidBody& body, const Step& step);

}  // namespace fccda
