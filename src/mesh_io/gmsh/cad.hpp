/// CAD files (STEP and IGES), meshed with the program `gmsh`.
#pragma once

#include <filesystem>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// A triangle mesh of all faces of the file, in metres whatever its unit. Parts are the faces, "surface 5" in gmsh's numbering; gmsh does not
/// pass on the names in the file. The mesh size gives 36 panels around a circle of the local curvature (deviation within 0.4 % of the radius),
/// and is at most a tenth of the model's diagonal. For another mesh size, mesh the file with gmsh and read its .msh.
///
/// IGES faces whose edges lie within 1 µm of one another are sewn together; STEP faces keep the topology of their solids and shells.
///
/// The program is found on PATH and run without a shell, in a temporary folder that is removed afterwards. Throws InputError where the
/// file is compressed, not a CAD file or has no surfaces, and where gmsh is missing, fails or reports any error: a face that it cannot
/// mesh would leave a hole. Throws RunError where the temporary folder cannot be created or written, or the program cannot be started.
Elements read_cad(const std::filesystem::path& path);

}  // namespace fccda
