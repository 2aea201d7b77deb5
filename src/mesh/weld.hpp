/// Welding: coincident vertices are merged. STL files repeat each vertex in every triangle, and files written part by part repeat those
/// along the seams.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/panels.hpp"

namespace fccda {

struct Welded {
  Panels panels;                ///< with only the remaining, used vertices, in the order of their first appearance
  std::vector<int> new_number;  ///< of each vertex of the panels as given: its number among those that remain; negative if no panel uses it
  std::size_t merged = 0;       ///< used vertices merged into another
};

/// Processes the vertices in order. Each is merged into the nearest vertex kept before if that is nearer than `tolerance` [m], or
/// coincident; otherwise it is kept. The result does not depend on the cells of the search. Linear in time and memory.
/// Expects vertex numbers in range and finite coordinates.
Welded weld(const Panels& panels, double tolerance);

}  // namespace fccda
