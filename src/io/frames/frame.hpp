/// A frame read back: the particles of a body, or the panels of an impactor.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "io/output/pvd.hpp"

namespace perimpact::frames {

/// A named point array, or cell array where there are panels.
struct FrameArray {
  std::string name;
  int components = 1;
  std::vector<double> numbers;  ///< `components` per point or panel

  std::size_t count() const { return numbers.size() / static_cast<std::size_t>(components); }
  /// The value at a point or panel; for vectors, their magnitude.
  double scalar(std::size_t i) const { return components == 3 ? std::hypot(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]) : numbers[i]; }
};

struct Frame {
  std::vector<fccda::Vec3d> points;        ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< point numbers; the fourth is -1 for triangles
  std::vector<FrameArray> arrays;          ///< point arrays, or cell arrays where there are panels
  std::vector<FrameArray> vertex_arrays;   ///< point arrays where there are panels

  const FrameArray* find(std::string_view name) const;              ///< of `arrays`; nullptr where there is none
  const FrameArray* find_of_vertices(std::string_view name) const;  ///< of `vertex_arrays`
};

/// The frames of a series, in order: of a .pvd list, or of a .vtkhdf file. Throws InputError where the file is none, or damaged.
std::vector<output::FrameFile> frames_of(const std::filesystem::path& series);

/// Reads a frame of either format. Throws InputError with the file where it is missing or damaged.
Frame read_frame(const output::FrameFile& frame);

/// The panels of a frame from the corner numbers of all of them and the end of each one's range. Throws InputError, with the words of `where`, where a
/// panel has not three or four corners, or one that is not a point.
std::vector<std::array<int, 4>> panels_of(const std::vector<std::int64_t>& corners, const std::vector<std::int64_t>& ends, std::size_t points,
                                          const std::string& where);

}  // namespace perimpact::frames
