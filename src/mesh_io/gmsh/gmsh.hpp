/// Gmsh's own format, .msh: versions 2, 4.0 and 4.1, as text or binary in either byte order.
///
/// Sources: Gmsh reference manual, sections "MSH file format", "Node ordering" and "Legacy formats"; for 4.0, which it no longer
/// describes, files that Gmsh 4.8 writes.
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Triangles, quads, tetrahedra, hexahedra, prisms and pyramids of first and second order; in solids of second order the nodes in the
/// middle of edges are used, those in the middle of faces are not. Parts are physical groups, by name or as "physical surface 3"; elements
/// in several groups are a part of their own, called by all names, "deck + hull". Elements in none are parts by the entity they mesh,
/// "surface 5" or "volume 2". An entity that its first group holds turned over is turned over. Points, lines and all sections that
/// say nothing of nodes, elements and groups are skipped. Throws InputError that names the file and the line (text) or the node or element
/// (binary, counted from 1).
Elements parse_gmsh(std::string_view contents, const std::string& file);

}  // namespace fccda
