/// Point cloud: unstructured particles from the points of a file or the cells of a mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

struct Cloud {
  std::vector<Vec3d> points;           ///< [m] reference positions
  std::vector<double> volumes;         ///< [m³] of each
  std::optional<double> thickness;     ///< [m] of a plane body, whose points share one z
  std::vector<std::uint32_t> numbers;  ///< numbers in the file; empty for 0, 1, 2 …
};

}  // namespace perimpact
