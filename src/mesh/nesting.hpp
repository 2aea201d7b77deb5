/// Which closed parts of a surface lie inside others: the inner wall of a hollow body must face the hollow.
#pragma once

#include <vector>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// For each component, how many closed ones contain it, and the innermost of them (-1: none).
struct Nesting {
  std::vector<int> depth, container;
};

/// A component is contained where the middles of its triangles (of 4000 to 8000 of
/// them, spread evenly, where it has more) are all inside, by the parity of the crossings of a ray; so a part that only reaches into
/// another, such as a blade sunk in its hub, is not. Open components neither contain nor are contained: their depth is 0. Winding does
/// not matter.
Nesting find_nesting(const LinkedTriangles& surface, const Components& components, const std::vector<bool>& component_is_closed);

}  // namespace fccda
