/// Triangles that lie in one place: repeated ones, and pairs that lie back to back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle.hpp"

namespace fccda {

struct Duplicates {
  std::size_t repeated = 0;      ///< left out: the same three vertices as an earlier one
  std::size_t back_to_back = 0;  ///< left out: both of a pair
};

/// Of triangles with the same three vertices all but the first go. Two that face opposite ways bound nothing between them, and where
/// they hang on other triangles both go:
///
/// - as a wall between two parts that share a face, which becomes one body so: no edge of the wall ends freely;
/// - as a crumb that sticks out without thickness (where both halves of a hull carry the panel in their common plane), of less than a
///   thousandth of the surface's area.
///
/// A larger sheet that sticks out, one that stands alone, and a part of a wall that is given from both sides (where both went, a hole would
/// be left) may be a part of the thing: one of its sides stays. The order of the others
/// stays. Expects welded vertices, and three different corners in each triangle.
Duplicates drop_duplicates(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices);

}  // namespace fccda
