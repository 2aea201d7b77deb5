/// Curvature of the smooth surface that triangles approximate, from their dihedral angles.
#pragma once

#include <array>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct Curvature {
  std::vector<double> largest;                 ///< [1/m] of each triangle, the larger principal curvature: 1/R of a cylinder
  std::vector<std::array<bool, 3>> is_crease;  ///< by triangle and edge: sharp, not part of a curve
};

/// An edge of bending angle θ between triangles of heights h and h' above it has the curvature κ = 2θ/(h + h') across itself. A triangle
/// has the tensor Σ κ d dᵀ over its edges, d the unit vector across the edge in its plane; the larger magnitude of its principal values is
/// kept. It is exact for evenly divided cylinders, and for spheres of equilateral or of halved square panels (the tensor of
/// Cohen-Steiner and Morvan, Symp. Comput. Geom. 2003, 312, with each edge spread over both its triangles).
///
/// Edges of more than 30°, that is, more than a twelfth of a circle, are regarded as creases: stems, knuckles, trailing edges.
Curvature curvature(const Surface& surface);

}  // namespace fccda
