/// Winding: all triangles of a component must have a consistent orientation, so that their normals point to one side.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// Components of triangles connected over edges.
struct Components {
  std::vector<int> of_triangle;  ///< component of each triangle
  std::size_t count = 0;         ///< number of components
  std::size_t rewound = 0;       ///< triangles flipped to agree with their component
};

/// Flips, in each component, the triangles that disagree with the majority (in a draw, with the component's first triangle).
/// Throws InputError if the surface is not orientable (a Möbius strip).
Components orient_consistently(LinkedTriangles& surface, const std::string& name);

}  // namespace fccda
