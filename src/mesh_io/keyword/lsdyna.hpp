/// LS-DYNA keyword files (.k, .key, .dyn).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// The mesh of an LS-DYNA keyword file's contents, in its units: *NODE, *ELEMENT_SHELL (with THICKNESS, BETA, MCID, OFFSET, DOF), *ELEMENT_SOLID (on one
/// card, or on two with up to ten nodes; ORTHO, DOF) and *ELEMENT_TSHELL (BETA), in fixed columns of any width or between commas. Shells and solids
/// that repeat nodes are the triangles, tetrahedra, pyramids and wedges they stand for. Beams, springs, masses, seatbelts and everything
/// that is no mesh are skipped. *END ends the file.
///
/// A part is called by the heading of its *PART, or `part 7` where that is blank, not there or that of another part too.
///
/// Throws InputError, one sentence with file and line. Refused by name: *INCLUDE, keywords that move nodes or copy parts, other kinds of
/// shells and solids, parameters (&name) in place of numbers.
Elements parse_lsdyna(std::string_view contents, const std::string& file);

}  // namespace fccda
