/// The cloud of a body whose particles a file gives: points with volumes, or the cells of a mesh.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/cloud.hpp"

namespace perimpact {

/// True where the shape of the body is a file of particles and not a solid.
bool is_cloud(const BodySetup& body);

/// In the world, along a space-filling curve; numbered by rows of the file, or by cells among those that became particles, from 0. Throws SetupError: a mesh
/// that cannot be read or has no cells of the kind that the body needs, cells without volume, two particles in one place, nothing left by the holes. Points and
/// cells in holes are left out.
Cloud cloud_of(const BodySetup& body);

}  // namespace perimpact
