/// Coarsening of surfaces that are finer than their shape requires, with a bound on the deviation.
#pragma once

#include "mesh/panels.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Limits of coarsening.
struct Coarsening {
  double max_deviation = 0;    ///< [m] bound of the distance from the new surface to the given one, and vice versa
  double max_edge_length = 0;  ///< [m] no longer edge is created
};

/// A coarsened surface, with its deviation.
struct Coarsened {
  Panels panels;             ///< triangles between vertices of the given surface, parts kept, oriented outward as by refine()
  double distance = 0;       ///< [m] proven bound of the distance between both surfaces, up to rounding
  double volume_change = 0;  ///< [m³] new minus old; 0 if the surface is open
};

/// Collapses edges (half-edge collapse: a vertex moves onto a neighbour), the shortest first, while a sum of bounds stays within the
/// deviation. Each triangle has a bound: that of the triangles it replaced, plus their displacement (fan_shift.hpp). So there is always a
/// one-to-one map between both surfaces that moves no point by more than `distance`, which bounds the two-sided Hausdorff distance.
///
///  - Closed surfaces stay closed; holes and components are kept (collapsible.hpp).
///  - Borders between parts, and boundaries, are kept: they too move by at most the deviation.
///  - No collapse turns a normal by more than 60° relative to the triangle that the new one replaces.
///  - No triangle becomes flatter than a twentieth (height over its longest edge), unless one about the vertex was flatter before.
///  - Thin walls and narrow gaps keep at least a third of their width (clearance.hpp): there the surface moves less than `distance`.
///
/// Bitwise reproducible across thread counts.
Coarsened coarsen(const Surface& surface, const Coarsening& wanted);

}  // namespace fccda
