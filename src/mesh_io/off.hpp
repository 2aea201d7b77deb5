/// OFF: vertices and polygons as text.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// Reads the faces of an OFF file, in its units; polygons with more than four corners are triangulated (add_polygon.hpp). Each line has one
/// vertex or face. The counts may be on the line of the word `OFF` or directly follow it, as in some model collections. Normals, colours and
/// texture coordinates of vertices and faces (NOFF, COFF, STOFF, …) and comments are skipped. The binary form and dimensions other than
/// three (4OFF, nOFF) are refused. There are no parts. Throws InputError with the file and the line.
///
/// Format: Geomview manual, OFF files, http://www.geomview.org/docs/html/OFF.html
Panels parse_off(std::string_view contents, const std::string& file);

}  // namespace fccda
