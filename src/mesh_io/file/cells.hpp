/// Volume (or area) and centroid of one mesh element, from its corner nodes; mid-side nodes are not used.
#pragma once

#include <optional>
#include <span>

#include "base/vec3.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

struct Cell {
  double measure;  ///< [m³] for a solid, [m²] for a surface element
  Vec3d centroid;  ///< [m]
};

/// Splits a solid into tetrahedra from its centre to the triangles between each face centre and the face's edges. For a hexahedron this gives
/// exactly the volume of the trilinear element. The orientation of the nodes does not matter. A surface element is split into triangles from
/// its first corner.
///
/// Returns nothing for a degenerate or self-folded element (more than a thousandth of its volume inverted), as occurs where the nodes are not in
/// the order of the file format.
std::optional<Cell> cell_of(ElementKind kind, std::span<const Vec3d> corners);

}  // namespace fccda
