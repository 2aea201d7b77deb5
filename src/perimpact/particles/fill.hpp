/// Lattice that fills a box.
#pragma once

#include <cmath>

#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// Lattice whose cells fill the box of `size` about `centre` exactly. The size is a whole multiple of the spacing (checked by the deck
/// reader); the outermost particles lie half a spacing inside. A plane body has one layer of the box's thickness.
inline Lattice lattice_of_box(const Vec3d& size, const Vec3d& centre, double spacing, bool is_plane) {
  Lattice lattice{.spacing = spacing};
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.cells[axis] = static_cast<int>(std::lround(size[axis] / spacing));
  if (is_plane) lattice.cells[2] = 1, lattice.thickness = size.z;
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.origin[axis] = centre[axis] - 0.5 * (lattice.cells[axis] - 1) * spacing;
  return lattice;
}

}  // namespace perimpact
