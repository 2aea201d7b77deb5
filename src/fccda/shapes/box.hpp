/// A box about the origin, its edges along the axes.
#pragma once

#include "fccda/shapes/divisions.hpp"
#include "fccda/surface/panels.hpp"

namespace fccda {

struct BoxShape {
  Vec3d size{};      ///< [m] edge lengths
  double panel = 0;  ///< [m] longest edge along the axes; diagonals are up to √2 longer
  PanelKind panels = PanelKind::triangles;
};

/// Wound outward, vertices shared, each edge of the box in the smallest number of equal parts.
/// Throws InputError where there would be too many panels.
Panels make_box(const BoxShape& shape);

}  // namespace fccda
