/// Volume and middle of one element of a mesh, over its corners: nodes in the middle of edges are not used.
#pragma once

#include <optional>
#include <span>

#include "base/vec3.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

struct Cell {
  double measure;  ///< [m³] of a solid, [m²] of a surface element
  Vec3d centroid;  ///< [m]
};

/// A solid is cut into tetrahedra from its centre to the triangles that its faces' middles make with their sides, which encloses just the volume
/// of the trilinear hexahedron. Which way round its nodes run does not matter. A surface element is cut into triangles from its first corner.
///
/// Nothing where it has no volume, or is turned in on itself (more than a thousandth of it is seen from behind), as solids are whose nodes are in
/// another order than the file's format has.
std::optional<Cell> cell_of(ElementKind kind, std::span<const Vec3d> corners);

}  // namespace fccda
