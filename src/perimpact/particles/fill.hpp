/// The lattice that fills a solid.
#pragma once

#include <cmath>

#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// A lattice whose cells fill a box of the given size about `centre` exactly; the size is a whole multiple of the spacing
/// (the deck reader has checked it), and the outermost particles lie half a spacing inside.
/// In the plane there is one layer, of the box's thickness.
inline Lattice lattice_of_box(const Vec3d& size, const Vec3d& centre, double spacing, bool is_plane) {
  Lattice lattice{.spacing = spacing};
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.cells[axis] = static_cast<int>(std::lround(size[axis] / spacing));
  if (is_plane) lattice.cells[2] = 1, lattice.thickness = size.z;
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.origin[axis] = centre[axis] - 0.5 * (lattice.cells[axis] - 1) * spacing;
  return lattice;
}

}  // namespace perimpact
