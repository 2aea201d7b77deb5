/// Panels to triangles: quads are split, those without area and repeated ones are left out.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/panels.hpp"
#include "mesh/triangle.hpp"

namespace fccda {

struct Triangulation {
  std::vector<Triangle> triangles;
  std::size_t degenerate = 0;    ///< left out: with a repeated corner, or slivers (slivers.hpp)
  std::size_t duplicate = 0;     ///< left out: the same three vertices as an earlier one, in any order
  std::size_t back_to_back = 0;  ///< left out: both of two that bound nothing (duplicates.hpp)
};

/// A quad is split along its shorter diagonal, a rectangle along the one from its lowest vertex number; but along the other where the shorter
/// one would leave a triangle without area or turned over (a quad with a corner on a straight side, or a re-entrant one).
/// A triangle that is at most `flat` [m] high has no area. Expects welded vertices.
Triangulation triangulate(const Panels& panels, double flat);

}  // namespace fccda
