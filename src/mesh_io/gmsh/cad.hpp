/// CAD files, STEP and IGES, meshed by the program `gmsh`.
#pragma once

#include <filesystem>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Triangles over all faces of the file, in metres, whatever its unit. Parts are the faces, "surface 5" as gmsh counts them; it does not hand
/// on the names that the file gives. Panels are so small that 36 would go around a circle of the local curvature (they lie within 0.4 % of the
/// radius), and at most a tenth of the model's diagonal long; who needs another size meshes the file with gmsh and reads its .msh.
///
/// Faces of IGES whose edges lie within 1 µm of one another are sewn together, those of STEP stay as its solids and shells have them.
///
/// The program is looked up on PATH and run without a shell, in a temporary folder that is gone afterwards. Throws InputError where the
/// file is packed, no CAD file or without surfaces, and where gmsh is not there, fails, or says that anything went wrong: a face
/// that it cannot mesh would leave a hole. Throws RunError where no temporary folder can be made or filled, or the program not be started.
Elements read_cad(const std::filesystem::path& path);

}  // namespace fccda
