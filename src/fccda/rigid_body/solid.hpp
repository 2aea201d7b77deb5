/// Mass, centre of mass and inertia of a homogeneous body with a closed surface.
#pragma once

#include "fccda/rigid_body/rigid_body.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// For a closed surface. With a density ρ [kg/m³] the mass is ρ times `surface.volume`. The shared volume of overlapping components counts twice.
inline RigidBodyProperties solid_of_mass(const SurfaceReport& surface, double mass) {
  const double density = mass / surface.volume;
  const Vec3d d = density * surface.inertia_diagonal, p = density * surface.inertia_products;
  return {.mass = mass, .centre_of_mass = surface.centroid, .inertia = {{{d.x, -p.z, -p.y}, {-p.z, d.y, -p.x}, {-p.y, -p.x, d.z}}}};
}

}  // namespace fccda
