/// The cloud of a body whose particles a file gives: points with volumes, or the cells of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "perimpact/particles/cloud.hpp"
#include "perimpact/setup/setup.hpp"

namespace perimpact {

struct NumberedCloud {
  Cloud cloud;                         ///< in the world, along a space-filling curve
  std::vector<std::uint32_t> numbers;  ///< of each point: its row in the file, or its cell among those that became particles, counted from 0
};

/// True where the shape of the body is a file of particles and not a solid.
bool is_cloud(const BodySetup& body);

/// Throws SetupError: a mesh that cannot be read or has no cells of the kind that the body needs, cells without volume, two particles in one
/// place, nothing left by the holes. Points and cells in holes are left out.
NumberedCloud cloud_of(const BodySetup& body);

}  // namespace perimpact
