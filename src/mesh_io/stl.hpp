/// STL: triangles without common vertices, as text or binary.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// The triangles of an STL file's contents, in its units. The stored normals are not used: the order of the vertices says the same, and
/// many programs write zeros. A binary file is known by its length, 84 + 50 n bytes, because many begin with the word `solid` of the
/// text form. Each `solid` of a text is a part, named by the rest of its line; a binary file has no parts. Throws InputError that names the file and the line
/// (text) or triangle (binary, counted from 1).
Panels parse_stl(std::string_view contents, const std::string& file);

}  // namespace fccda
