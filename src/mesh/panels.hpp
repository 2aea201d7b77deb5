/// Panels as read from a file or made by a generator, before anything is checked or mended.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Triangles and quads over a list of vertices. Files without shared vertices (STL) list three new ones a panel.
struct Panels {
  std::vector<Vec3d> vertices;             ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< vertex numbers in order around the panel; the fourth is -1 in a triangle

  /// Named parts (part_naming.hpp): which of `part_names` each panel belongs to. Both empty: all panels are one nameless part.
  std::vector<int> part;
  std::vector<std::string> part_names;

  void add_triangle(int a, int b, int c) { panels.push_back({a, b, c, -1}); }
  void add_quad(int a, int b, int c, int d) { panels.push_back({a, b, c, d}); }
};

}  // namespace fccda
