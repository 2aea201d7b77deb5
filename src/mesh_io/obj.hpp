/// Wavefront OBJ: vertices `v x y z` and faces `f a b c …`.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// The faces of an OBJ file's contents, in its units: triangles and quads as they are, larger polygons cut into triangles
/// (add_polygon.hpp). Vertex numbers may be negative (counted back from the last vertex so far) and may carry texture and normal numbers
/// (`7/2/9`), which are not used; neither are lines, points and materials. Groups (`g`) and objects (`o`) are parts: a face
/// belongs to the latest statement of either kind before it, named by the rest of its line. Throws InputError that names the file and the line.
Panels parse_obj(std::string_view contents, const std::string& file);

}  // namespace fccda
