/// Whether an impactor acts on a plane body as if both went on along z for ever, which is what a plane body stands for.
#pragma once

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Throws a SetupError unless the impactor stays in the plane, moving along x and y and turning about z alone, and its surface is prismatic
/// along z where the particles' contact spheres can meet it: every panel that comes within `reach` [m] of their plane stands upright. Then
/// contact puts particles back, and pushes them, in their plane.
void expect_in_plane(const ImpactorSetup& setup, const Impactor& impactor, const Particles& particles, double reach);

}  // namespace perimpact
