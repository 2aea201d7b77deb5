/// Nesting of the closed parts of a surface: the inner wall of a hollow body must face the cavity.
#pragma once

#include <vector>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// For each component, the number of closed components that contain it, and the innermost of them (-1: none).
struct Nesting {
  std::vector<int> depth, container;
};

/// A component is contained if the centroids of its triangles (of 4000 to 8000 evenly distributed ones, if it has more) are all inside, by
/// the parity of ray crossings. So a part that only penetrates another, such as a blade embedded in its hub, is not contained. Open
/// components neither contain nor are contained: their depth is 0. Winding is irrelevant.
Nesting find_nesting(const LinkedTriangles& surface, const Components& components, const std::vector<bool>& component_is_closed);

}  // namespace fccda
