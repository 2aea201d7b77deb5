/// Reader of one frame file: the particles of a body, or the panels of an impactor.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact::report {

/// A named point array, or cell array where there are panels.
struct FrameArray {
  std::string name;
  int components = 1;
  std::vector<double> numbers;  ///< `components` per point or panel

  std::size_t count() const { return numbers.size() / static_cast<std::size_t>(components); }
  /// The value at a point or panel; for vectors, their magnitude.
  double scalar(std::size_t i) const { return components == 3 ? std::hypot(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]) : numbers[i]; }
};

struct FrameReader {
  std::vector<fccda::Vec3d> points;        ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< point numbers; the fourth is -1 for triangles
  std::vector<FrameArray> arrays;          ///< point arrays, or cell arrays where there are panels

  const FrameArray* find(std::string_view name) const;  ///< nullptr where there is none
};

/// Reads a file written by output::write_vtp. Throws InputError with the file and the line where it is missing or damaged.
FrameReader read_frame(const std::filesystem::path& path);

}  // namespace perimpact::report
