/// A box about the origin, its edges along the axes.
#pragma once

#include "mesh/panels.hpp"
#include "mesh/shapes/divisions.hpp"

namespace fccda {

struct BoxShape {
  Vec3d size{};            ///< [m] edge lengths
  double edge_length = 0;  ///< [m] longest edge along the axes; diagonals are up to √2 longer. 0: each side of the box is one quad, or two triangles
  PanelKind panels = PanelKind::triangles;
};

/// Wound outward, vertices shared, each edge of the box in the smallest number of equal parts.
/// Throws InputError where a size is not positive and finite, or there would be too many panels.
Panels make_box(const BoxShape& shape);

}  // namespace fccda
