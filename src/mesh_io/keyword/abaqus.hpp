/// Abaqus input files (.inp).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// The mesh of an Abaqus input file's contents, in its units: nodes (*NODE), and shells, membranes, surface and rigid elements, and solids
/// (*ELEMENT; abaqus_types.hpp). Instances stand where *INSTANCE puts them; a part without an instance is not there where the file has an assembly.
/// Plane elements (CPS, CPE, CAX) are surface elements: Gmsh and meshio write those of a surface in space so. Lines, points and springs are skipped, and so is
/// everything that is no mesh.
///
/// Names of parts: what ELSET= says on *ELEMENT; else the smallest *ELSET that lists the element (those that Abaqus/CAE makes for itself, and those that
/// share an element with a smaller one, count as none); else the instance or part, with " (rest)" where sets have taken some of its
/// elements. With more than one instance, a set's name follows that of its instance: `HULL-1.BOW`.
///
/// Throws InputError, one sentence with file and line. Refused by name: *INCLUDE and INPUT=, keywords that make nodes or elements (*NGEN, *ELGEN …), other
/// coordinate systems, generalised plane elements, analytical surfaces.
Elements parse_abaqus(std::string_view contents, const std::string& file);

}  // namespace fccda
