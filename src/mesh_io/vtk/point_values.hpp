/// Points of VTK files with one scalar each, as meshfree codes write their particles.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

struct PointValues {
  std::vector<Vec3d> points;   ///< in the file's units
  std::vector<double> values;  ///< one per point
};

/// Reads the points of a file (.vtk, .vtp or .vtu, followed by `.gz` where compressed) and the scalar point array of that name, all pieces
/// concatenated; cells are skipped. Formats: vtk.hpp and vtp.hpp. Throws InputError where the file or the scalar array does not exist (the
/// message lists the available arrays) or the contents are damaged.
PointValues read_point_values(const std::filesystem::path& path, std::string_view array);

}  // namespace fccda
