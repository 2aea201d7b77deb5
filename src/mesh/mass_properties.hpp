/// Volume, centroid and moments of inertia of what closed triangles enclose.
#pragma once

#include <span>

#include "mesh/triangle.hpp"

namespace fccda {

struct MassProperties {
  double volume = 0;         ///< [m³], negative where the normals point inward
  Vec3d centroid{};          ///< [m]
  Vec3d inertia_diagonal{};  ///< [m⁵] ∫(y²+z²) dV, ∫(z²+x²) dV, ∫(x²+y²) dV about the centroid
  Vec3d inertia_products{};  ///< [m⁵] ∫yz dV, ∫zx dV, ∫xy dV about the centroid
};

/// By the divergence theorem: the sum over the tetrahedra from a point o to each triangle (a, b, c), with signs. With corners seen from
/// o, d = a·(b×c) and s = a + b + c, a tetrahedron has
///   ∫dV = d/6,   ∫x dV = d s/24,   ∫x xᵀ dV = d (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/120
/// (Tonon, J. Math. Stat. 1 (2005) 8). The point o is the middle of the bounds, so that a surface far from the origin loses no digits.
/// Where closed parts overlap, what they share counts twice.
MassProperties mass_properties(const LinkedTriangles& surface);

/// The signed volume alone, of some of the triangles.
double signed_volume(const LinkedTriangles& surface, std::span<const std::size_t> triangles);

}  // namespace fccda
