/// Checks that an impactor is compatible with a plane body, that is prismatic along z and moving in the plane.
#pragma once

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Throws a SetupError unless the impactor stays in the plane, translating along x and y and rotating about z only, and its surface is prismatic
/// along z where the particles' contact spheres can meet it: every panel within `reach` [m] of their plane is parallel to z. Contact then acts
/// in the plane only.
void expect_in_plane(const ImpactorSetup& setup, const Impactor& impactor, const Particles& particles, double reach);

}  // namespace perimpact
