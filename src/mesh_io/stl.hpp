/// STL: unconnected triangles, text or binary.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// Reads the triangles of an STL file, in its units. Stored normals are ignored: the vertex order defines the orientation, and many
/// programs write zeros. A binary file is recognised by its length, 84 + 50 n bytes, because many begin with the word `solid` of the text
/// form. Each `solid` of a text file is a part, named by the rest of its line; a binary file has no parts. Throws InputError with the file
/// and the line (text) or triangle (binary, counted from 1).
Panels parse_stl(std::string_view contents, const std::string& file);

}  // namespace fccda
