/// Normals of faces, edges and vertices, such that the sign of (point - closest point)·normal gives the side of a point.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

/// Unit vectors. Bærentzen and Aanæs, IEEE Transactions on Visualization and Computer Graphics 11 (2005) 243: the mean of both faces on
/// an edge; on a vertex the mean weighted by the angles of the faces there.
struct Pseudonormals {
  std::vector<Vec3d> faces;                 ///< of each triangle
  std::vector<std::array<Vec3d, 3>> edges;  ///< of each triangle's edges; on a boundary edge that of the face
  std::vector<Vec3d> vertices;              ///< of each vertex
};

/// Where the faces cancel, as on the edge of a sheet folded onto itself, the normal points away from them, in their plane: there is no
/// inside. Expects consistent winding.
Pseudonormals pseudonormals(const LinkedTriangles& surface);

}  // namespace fccda
