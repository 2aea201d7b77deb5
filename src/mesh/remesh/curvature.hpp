/// How strongly the smooth surface bends for which triangles stand, from the angles between them.
#pragma once

#include <array>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct Curvature {
  std::vector<double> largest;                 ///< [1/m] of each triangle, the larger principal curvature: 1/R of a cylinder
  std::vector<std::array<bool, 3>> is_crease;  ///< of each edge of each triangle: sharp, and no part of a curve
};

/// An edge that bends by θ between triangles that are h and h' high above it has the curvature κ = 2θ/(h + h') across itself. A triangle
/// has the tensor Σ κ d dᵀ over its edges, d the unit vector across the edge in its plane; the larger of the magnitudes of its principal
/// values is kept. It is exact for evenly cut cylinders, and for spheres of equilateral or of halved square panels (the tensor of
/// Cohen-Steiner and Morvan, Symp. Comput. Geom. 2003, 312, with each edge spread over both its triangles).
///
/// Edges that bend by more than 30°, that is more than a twelfth of a circle, are taken for creases: stems, knuckles, trailing edges.
Curvature curvature(const Surface& surface);

}  // namespace fccda
