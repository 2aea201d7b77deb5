/// Points of VTK files with numbers: one scalar each, as meshfree codes write their particles, or arrays of any kind.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
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

/// An array with its tuples one after another.
struct TupleArray {
  std::string name;
  std::size_t components = 1;
  std::vector<double> values;  ///< finite
};

struct PointData {
  std::vector<Vec3d> points;          ///< in the file's units
  std::vector<TupleArray> of_points;  ///< a tuple for each point
  std::vector<TupleArray> of_file;    ///< field data
};

/// Selects an array by its name and its number of components.
using ArrayFilter = std::function<bool(std::string_view name, std::size_t components)>;

/// The same with all point arrays and field data that `is_wanted` selects. Throws InputError where the file does not exist, its pieces have different
/// arrays, an array has not one tuple per point, or the contents are damaged.
PointData read_point_arrays(const std::filesystem::path& path, const ArrayFilter& is_wanted);

}  // namespace fccda
