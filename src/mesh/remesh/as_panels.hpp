/// Conversion of modified triangles of a surface back to panels.
#pragma once

#include <array>

#include "mesh/surface.hpp"

namespace fccda {

/// Panels with the part names of the surface, but no vertices or panels yet.
inline Panels empty_panels(const Surface& surface) {
  Panels panels;
  if (!surface.panels().part.empty()) panels.part_names.assign(surface.part_names().begin(), surface.part_names().end());
  return panels;
}

/// Adds a triangle with the part of a given triangle of the surface.
inline void add_triangle_like(const Surface& surface, int triangle, const std::array<int, 3>& vertex, Panels& panels) {
  panels.add_triangle(vertex[0], vertex[1], vertex[2]);
  if (!panels.part_names.empty()) panels.part.push_back(surface.part_of_panel(surface.triangles()[static_cast<std::size_t>(triangle)].panel));
}

}  // namespace fccda
