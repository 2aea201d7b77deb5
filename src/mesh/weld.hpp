/// Welding: vertices that lie in one place become one. STL files repeat each vertex in every triangle, and programs that write
/// part by part repeat those on the seams.
#pragma once

#include <cstddef>

#include "mesh/panels.hpp"

namespace fccda {

struct Welded {
  Panels panels;           ///< with only the vertices that remain and are used, in the order of their first appearance
  std::size_t merged = 0;  ///< used vertices that became another
};

/// Going through the vertices in order, each becomes one with the nearest that was kept before if that is nearer than `tolerance` [m],
/// or in the same place; else it is kept. Where cells of the search begin and end has no influence. Linear in time and memory.
/// Expects vertex numbers in range and finite coordinates.
Welded weld(const Panels& panels, double tolerance);

}  // namespace fccda
