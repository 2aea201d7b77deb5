/// LS-DYNA keyword files (.k, .key, .dyn).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Reads the mesh of an LS-DYNA keyword file, in its units: *NODE, *ELEMENT_SHELL (with THICKNESS, BETA, MCID, OFFSET, DOF), *ELEMENT_SOLID (on
/// one card, or on two with up to ten nodes; ORTHO, DOF) and *ELEMENT_TSHELL (BETA), in fixed columns of any width or comma-separated. Shells
/// and solids with repeated nodes are converted to the triangles, tetrahedra, pyramids and wedges they represent. Beams, springs, masses,
/// seatbelts and everything other than the mesh are skipped. *END ends the file.
///
/// A part is named by the heading of its *PART, or `part 7` where that is blank, missing or ambiguous.
///
/// Throws InputError with file and line. Not supported, and refused by name: *INCLUDE, keywords that move nodes or copy parts, other kinds of
/// shells and solids, parameters (&name) in place of numbers.
Elements parse_lsdyna(std::string_view contents, const std::string& file);

}  // namespace fccda
