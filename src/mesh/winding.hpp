/// Winding: all triangles of a component must run around in the same sense, so that their normals point to one side.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// A component is what hangs together over edges.
struct Components {
  std::vector<int> of_triangle;
  std::size_t count = 0;
  std::size_t rewound = 0;  ///< triangles turned over to agree with their component
};

/// Turns over, in each component, the triangles that disagree with the majority (in a draw, with the component's first triangle).
/// Throws InputError where no winding is consistent (a Möbius strip).
Components orient_consistently(LinkedTriangles& surface, const std::string& name);

}  // namespace fccda
