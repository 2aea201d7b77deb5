/// Abaqus input files (.inp).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Reads the mesh of an Abaqus input file, in its units: nodes (*NODE), and shell, membrane, surface, rigid and solid elements (*ELEMENT;
/// abaqus_types.hpp). Instances are positioned as *INSTANCE specifies; in a file with an assembly, parts without an instance are omitted.
/// Plane elements (CPS, CPE, CAX) count as surface elements, since Gmsh and meshio write the elements of 3-D surfaces so. Lines, points,
/// springs and everything other than the mesh are skipped.
///
/// Part names: ELSET= on *ELEMENT; else the smallest *ELSET that lists the element (internal sets of Abaqus/CAE, and sets that share an element
/// with a smaller one, are ignored); else the instance or part, with " (rest)" where sets have taken some of its elements. With more than
/// one instance, the name of the instance precedes that of the set: `HULL-1.BOW`.
///
/// Throws InputError with file and line. Not supported, and refused by name: *INCLUDE and INPUT=, keywords that generate nodes or elements
/// (*NGEN, *ELGEN …), other coordinate systems, generalised plane elements, analytical surfaces.
Elements parse_abaqus(std::string_view contents, const std::string& file);

}  // namespace fccda
