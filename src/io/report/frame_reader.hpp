/// One picture of frames/, read back: the particles of a body, or the panels of an impactor.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact::report {

/// A named array of points, or of panels where there are any.
struct FrameArray {
  std::string name;
  int components = 1;
  std::vector<double> numbers;  ///< `components` of each point or panel in turn

  std::size_t count() const { return numbers.size() / static_cast<std::size_t>(components); }
  /// The number of a point or panel; of vectors, their magnitude.
  double scalar(std::size_t i) const { return components == 3 ? std::hypot(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]) : numbers[i]; }
};

struct FrameReader {
  std::vector<fccda::Vec3d> points;        ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< numbers of points; the fourth -1 for triangles
  std::vector<FrameArray> arrays;          ///< of the points, or of the panels where there are any

  const FrameArray* find(std::string_view name) const;  ///< nullptr where there is none
};

/// Reads a file that output::write_vtp has written. Throws InputError, a sentence with the file and the line, where it is missing or damaged.
FrameReader read_frame(const std::filesystem::path& path);

}  // namespace perimpact::report
