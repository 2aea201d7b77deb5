/// Wavefront OBJ: vertices `v x y z` and faces `f a b c …`.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// Reads the faces of an OBJ file, in its units: triangles and quads unchanged, larger polygons triangulated (add_polygon.hpp). Vertex
/// numbers may be negative (counted back from the latest vertex) and may carry texture and normal numbers (`7/2/9`), which are ignored, as
/// are lines, points and materials. Groups (`g`) and objects (`o`) are parts: a face belongs to the latest such statement before it, named
/// by the rest of its line. Throws InputError with the file and the line.
Panels parse_obj(std::string_view contents, const std::string& file);

}  // namespace fccda
