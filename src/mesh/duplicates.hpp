/// Removal of coincident triangles: repeated ones, and pairs that lie back to back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

struct Duplicates {
  std::size_t repeated = 0;      ///< removed: the same three vertices as an earlier one
  std::size_t back_to_back = 0;  ///< removed: both triangles of a pair
};

/// Of triangles with the same three vertices, all but the first are removed. Two of opposite winding enclose nothing between them, and where
/// they are connected to other triangles both are removed:
///
/// - as a wall between two parts that share a face, which thereby become one body: no edge of the wall is free;
/// - as a small fin without thickness (where both halves of a hull contain the panel in their common plane), of less than a thousandth of
///   the surface's area.
///
/// A larger fin, an isolated sheet, and a part of a wall given from both sides (removing both would leave a hole) may belong to the geometry:
/// one side is kept. The order of the other triangles is kept. Expects welded vertices, and three different corners in each triangle.
Duplicates drop_duplicates(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices);

}  // namespace fccda
