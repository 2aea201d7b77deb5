/// PLY: vertices and polygons with any properties, as text or binary.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// The faces of a PLY file's contents, in its units: x, y, z of `vertex` and the list `vertex_indices` (or `vertex_index`) of `face`, in
/// whatever order and of whatever types; polygons with more than four corners are cut into triangles (add_polygon.hpp). Other properties
/// (normals, colours) and elements (edges, materials) are passed over, triangle strips refused. There are no parts. Throws InputError that
/// names the file and the line (text) or the element (binary, counted from 1).
Panels parse_ply(std::string_view contents, const std::string& file);

}  // namespace fccda
