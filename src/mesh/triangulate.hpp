/// Triangulation of panels: quads are split; degenerate and repeated panels are dropped.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/panels.hpp"
#include "mesh/triangle.hpp"

namespace fccda {

struct Triangulation {
  std::vector<Triangle> triangles;
  std::size_t degenerate = 0;    ///< dropped: with a repeated corner, or slivers (slivers.hpp)
  std::size_t duplicate = 0;     ///< dropped: the same three vertices as an earlier one, in any order
  std::size_t back_to_back = 0;  ///< dropped: both of two that enclose nothing (duplicates.hpp)
};

/// A quad is split along its shorter diagonal, a rectangle along the one from its lowest vertex number. The other diagonal is used if the
/// shorter one would leave a triangle without area or with reversed winding (a quad with a corner on a straight side, or a re-entrant one).
/// A triangle of a height of at most `flat` [m] has no area. Expects welded vertices.
Triangulation triangulate(const Panels& panels, double flat);

}  // namespace fccda
