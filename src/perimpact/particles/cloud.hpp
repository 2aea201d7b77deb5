/// Point cloud: unstructured particles from the points of a file or the cells of a mesh.
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
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

/// [m] edge of a cube of that volume; of a square in a plane body of that thickness.
inline double size_of_volume(double volume, const std::optional<double>& thickness) { return thickness ? std::sqrt(volume / *thickness) : std::cbrt(volume); }

/// [m] of a particle of mean volume.
inline double spacing_of(const Cloud& cloud) {
  return size_of_volume(std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0) / static_cast<double>(cloud.volumes.size()), cloud.thickness);
}

}  // namespace perimpact
