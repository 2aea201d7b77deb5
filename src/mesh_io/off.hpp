/// OFF: vertices and polygons as text.
#pragma once

#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

/// The faces of an OFF file's contents, in its units; polygons with more than four corners are cut into triangles (add_polygon.hpp). A
/// vertex or face a line; the counts may stand in the line of the word `OFF`, or stick to it as some collections have them.
/// Normals, colours and texture coordinates behind vertices and faces (NOFF, COFF, STOFF, …) and comments are passed over; the binary form
/// and other dimensions than three (4OFF, nOFF) are refused. There are no parts. Throws InputError that names the file and the line.
///
/// Format: Geomview manual, OFF files, http://www.geomview.org/docs/html/OFF.html
Panels parse_off(std::string_view contents, const std::string& file);

}  // namespace fccda
