/// Normals of faces, edges and vertices, such that the sign of (point - closest point)·normal gives the side of a point.
#pragma once

#include <array>
#include <cstdint>
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

/// The triangles at each vertex, in ascending order: those of vertex v are triangles[begin[v]] to triangles[begin[v + 1]].
struct IncidentTriangles {
  std::vector<std::int32_t> begin;      ///< one more than there are vertices
  std::vector<std::int32_t> triangles;  ///< their numbers
};

IncidentTriangles incident_triangles(const LinkedTriangles& surface);  ///< depends on the vertex numbers alone

/// A single normal, bitwise equal to that of `pseudonormals`. For surfaces whose vertices move, of which few normals are needed in a step.
Vec3d pseudonormal(const LinkedTriangles& surface, const IncidentTriangles& incident, std::size_t triangle, Feature feature);

}  // namespace fccda
