/// A prism over a polygon of the plane z = 0: what a plane outline is to codes in two dimensions.
#pragma once

#include <array>
#include <vector>

#include "mesh/panels.hpp"

namespace fccda {

struct PrismShape {
  std::vector<std::array<double, 2>> outline;  ///< [m] x and y of its corners, in either direction around; concave ones too
  double height = 1;  ///< [m] half of it above the plane. Points of the plane never feel its ends where it is more than two contact radii
};

/// A quad for each side, and the two ends. Throws InputError where the outline has fewer than three corners or crosses itself, a number is not finite, or
/// the height not positive.
Panels make_prism(const PrismShape& shape);

}  // namespace fccda
