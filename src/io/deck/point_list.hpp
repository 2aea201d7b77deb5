/// Point cloud from a CSV file:
///
///   x [m], y [m], z [m], volume [m3]
///   0, 0, 0, 1e-9
///   0.001, 0, 0, 1e-9
///
/// The first line names the four columns, in any order, with their units, which are converted to SI.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact::deck {

struct PointList {
  std::vector<fccda::Vec3d> points;  ///< [m]
  std::vector<double> volumes;       ///< [m³], all above 0
};

/// Throws InputError: at `place` (of the deck) if the file does not exist, else at "file:line" of the invalid row.
PointList read_point_list(const std::filesystem::path& file, const std::string& place);

}  // namespace perimpact::deck
