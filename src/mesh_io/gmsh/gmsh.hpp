/// Gmsh mesh format (.msh): versions 2, 4.0 and 4.1, text or binary in either byte order.
///
/// Sources: Gmsh reference manual, sections "MSH file format", "Node ordering" and "Legacy formats"; for version 4.0, which the manual no
/// longer describes, files written by Gmsh 4.8.
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Reads triangles, quads, tetrahedra, hexahedra, prisms and pyramids of first and second order. Of second-order solids the mid-side
/// nodes are used, mid-face nodes are not. Parts are physical groups, by name or as "physical surface 3"; elements in several groups form
/// a separate part that joins the names, "deck + hull". Elements in no group are named after their entity, "surface 5" or "volume 2". An
/// entity that is reversed in its first group is reversed. Points, lines and sections that do not concern nodes, elements or groups are
/// skipped. Throws InputError with the file and the line (text) or the node or element (binary, counted from 1).
Elements parse_gmsh(std::string_view contents, const std::string& file);

}  // namespace fccda
