/// Unprocessed panels, as read from a file or generated, before any check or repair.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Triangles and quads over a list of vertices. Files without shared vertices (STL) list three per panel.
struct Panels {
  std::vector<Vec3d> vertices;             ///< [m]
  std::vector<std::array<int, 4>> panels;  ///< vertex numbers in order around the panel; the fourth is -1 in a triangle

  /// Named parts (part_naming.hpp): the index into `part_names` of each panel. Both empty: all panels form one unnamed part.
  std::vector<int> part;
  std::vector<std::string> part_names;  ///< names of the parts

  void add_triangle(int a, int b, int c) { panels.push_back({a, b, c, -1}); }    ///< by vertex numbers in order around it
  void add_quad(int a, int b, int c, int d) { panels.push_back({a, b, c, d}); }  ///< by vertex numbers in order around it
};

}  // namespace fccda
