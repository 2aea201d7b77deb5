/// Triangles of a surface, changed, as panels again.
#pragma once

#include <array>

#include "mesh/surface.hpp"

namespace fccda {

/// Panels without any vertex or panel yet, with the part names of the surface.
inline Panels empty_panels(const Surface& surface) {
  Panels panels;
  if (!surface.panels().part.empty()) panels.part_names.assign(surface.part_names().begin(), surface.part_names().end());
  return panels;
}

/// Adds a triangle that belongs to the part of a triangle of the surface.
inline void add_triangle_like(const Surface& surface, int triangle, const std::array<int, 3>& vertex, Panels& panels) {
  panels.add_triangle(vertex[0], vertex[1], vertex[2]);
  if (!panels.part_names.empty()) panels.part.push_back(surface.part_of_panel(surface.triangles()[static_cast<std::size_t>(triangle)].panel));
}

}  // namespace fccda
