/// Larger panels where a surface is cut finer than its shape needs, with a bound on how far it moves.
#pragma once

#include "mesh/panels.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct Coarsening {
  double max_deviation = 0;    ///< [m] the new surface lies within this of the given one, and the given one within this of the new one
  double max_edge_length = 0;  ///< [m] no edge is made longer
};

struct Coarsened {
  Panels panels;             ///< triangles between vertices of the given surface, parts kept, wound outward as refine() has them
  double distance = 0;       ///< [m] what is proven of the distance between both surfaces, up to rounding
  double volume_change = 0;  ///< [m³] new less old; 0 where the surface is open
};

/// Puts vertices onto neighbours, those with the shortest edges first, as long as a sum of bounds stays within the distance. Each
/// triangle carries one: that of the triangles it took the place of, plus how far they moved (fan_shift.hpp). So there is always a one-to-one
/// map between both surfaces that moves no point by more than `distance`, which bounds Hausdorff's distance in both directions.
///
///  - Closed stays closed; holes and components stay (collapsible.hpp).
///  - Borders between parts, and rims, stay borders and rims: they move by at most the distance too.
///  - No collapse turns a normal by more than 60° against that of the triangle in whose place the new one is.
///  - No triangle becomes flatter than a twentieth (height over its longest edge), unless one about the vertex was flatter before.
///  - Thin walls and narrow gaps keep a third of their width at least (room.hpp): there the surface moves less than `distance`.
///
/// The same for any number of threads.
Coarsened coarsen(const Surface& surface, const Coarsening& wanted);

}  // namespace fccda
