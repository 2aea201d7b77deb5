/// Volume, centroid and moments of inertia of the volume enclosed by closed triangles.
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

/// By the divergence theorem: the signed sum over the tetrahedra from a point o to each triangle (a, b, c). With corners relative to
/// o, d = a·(b×c) and s = a + b + c, a tetrahedron has
///   ∫dV = d/6,   ∫x dV = d s/24,   ∫x xᵀ dV = d (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/120
/// (Tonon, J. Math. Stat. 1 (2005) 8). The point o is the centre of the bounding box, so a surface far from the origin loses no digits.
/// Where closed parts overlap, the shared volume counts twice.
MassProperties mass_properties(const LinkedTriangles& surface);

/// The signed volume alone, of a subset of the triangles.
double signed_volume(const LinkedTriangles& surface, std::span<const std::size_t> triangles);

}  // namespace fccda
