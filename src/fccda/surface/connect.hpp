/// Which triangles share an edge.
#pragma once

#include <cstddef>
#include <string>

#include "fccda/surface/triangle.hpp"

namespace fccda {

/// Finds the neighbours and returns the number of rim edges, those with one triangle. Throws InputError, which names panels, where
/// more than two triangles share an edge. Expects triangles without repeated vertices.
std::size_t connect(LinkedTriangles& surface, const std::string& name);

}  // namespace fccda
