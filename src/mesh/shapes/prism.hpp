/// A prism over a polygon in the plane z = 0: the counterpart of an outline in a 2-D code.
#pragma once

#include <array>
#include <vector>

#include "mesh/panels.hpp"

namespace fccda {

/// Dimensions of a prism.
struct PrismShape {
  std::vector<std::array<double, 2>> outline;  ///< [m] x and y of its corners, in either direction around; may be concave
  double height = 1;                           ///< [m] half of it above the plane. Above two contact radii, points in the plane are unaffected by its ends
};

/// A quad for each side, and the two ends. Throws InputError if the outline has fewer than three corners or crosses itself, a number is not
/// finite, or the height is not positive.
Panels make_prism(const PrismShape& shape);

}  // namespace fccda
