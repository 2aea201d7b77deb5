/// A box about the origin, with axis-aligned edges.
#pragma once

#include "mesh/panels.hpp"
#include "mesh/shapes/divisions.hpp"

namespace fccda {

/// Dimensions of a box.
struct BoxShape {
  Vec3d size{};            ///< [m] edge lengths
  double edge_length = 0;  ///< [m] longest edge along the axes; diagonals are up to √2 longer. 0: each side of the box is one quad, or two triangles
  PanelKind panels = PanelKind::triangles;  ///< kind of panels
};

/// Oriented outward, with shared vertices, each edge of the box in the smallest number of equal parts.
/// Throws InputError if a size is not positive and finite, or the number of panels exceeds the limit.
Panels make_box(const BoxShape& shape);

}  // namespace fccda
