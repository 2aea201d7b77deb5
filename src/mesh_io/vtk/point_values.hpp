/// Points of VTK files with a number each, as meshless programs write their particles.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

struct PointValues {
  std::vector<Vec3d> points;   ///< in the file's units
  std::vector<double> values;  ///< one of each
};

/// The points of a file (.vtk, .vtp or .vtu; with `.gz` behind it where packed) and what the point array of that name says of them, all pieces
/// one after the other; cells are passed over. Formats as vtk.hpp and vtp.hpp say. Throws InputError where there is no such file, no such array
/// of one number a point (the names that there are being told), or the contents are damaged.
PointValues read_point_values(const std::filesystem::path& path, std::string_view array);

}  // namespace fccda
