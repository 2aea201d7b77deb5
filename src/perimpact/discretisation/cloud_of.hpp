/// Point cloud of a body from a file: points with volumes, or the cells of an unstructured mesh.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/cloud.hpp"

namespace perimpact {

/// True if the shape of the body is a file of particles rather than a solid.
bool is_cloud(const BodySetup& body);

/// In global coordinates, ordered along a space-filling curve; numbered from 0 by rows of the file or by the cells used. Points and cells in
/// holes are left out. Throws SetupError for an unreadable mesh, one without suitable cells, cells without volume, coincident particles, or
/// if no particle remains.
Cloud cloud_of(const BodySetup& body);

}  // namespace perimpact
