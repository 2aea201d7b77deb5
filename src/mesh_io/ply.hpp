/// PLY: vertices and polygons with arbitrary properties, text or binary.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// Reads the faces of a PLY file, in its units: x, y, z of `vertex` and the list `vertex_indices` (or `vertex_index`) of `face`, in any
/// order and of any type; polygons with more than four corners are triangulated (add_polygon.hpp). Other properties (normals, colours) and
/// elements (edges, materials) are skipped; triangle strips are refused. There are no parts. Throws InputError with the file and the line
/// (text) or the element (binary, counted from 1).
Panels parse_ply(std::string_view contents, const std::string& file);

}  // namespace fccda
