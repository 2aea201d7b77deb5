/// One picture of frames/, read back: the particles of a body, or the panels of an impactor.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fccda/core/vec3.hpp"

namespace perimpact::report {

/// A named array of points, or of panels where there are any.
struct PictureArray {
  std::string name;
  int components = 1;
  std::vector<double> numbers;  ///< `components` of each point or panel in turn
};

struct PictureFile {
  std::vector<fccda::Vec3d> points;        ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< numbers of points; the fourth -1 for triangles
  std::vector<PictureArray> arrays;        ///< of the points, or of the panels where there are any

  const PictureArray* find(std::string_view name) const;  ///< nullptr where there is none
};

/// Reads a file that output::write_vtp has written. Throws InputError, a sentence with the file and the line, where it is missing or damaged.
PictureFile read_picture(const std::filesystem::path& path);

}  // namespace perimpact::report
