/// Distribution of a contact impulse over the three vertices of a triangle, such that linear and angular momentum are conserved.
///
/// The impulse J acts at x, beside the triangle by the contact radius. With x̂ the triangle's point of the weights w_i, vertex i gets
///   j_i = w_i J + (∇w_i·q) n + β n × (x_i - c)
/// where the last two are the couple M = (x - x̂) × J, resolved along the triangle's normal n: q = n × M, β = M·n / Σ|x_i - c|², c the centroid. Then
///   Σ j_i = J,   Σ x_i × j_i = x × J
/// exactly. Without friction J is parallel to x - x̂, and the couple vanishes: the distribution by weights. With friction the couple is r J_t.
#pragma once

#include <array>

#include "mesh/search/closest_point.hpp"

namespace fccda {

/// The impulses of the three vertices [N s]. `impulse` [N s] acts at `place` [m]; `weights`: barycentric coordinates of the triangle's point there.
std::array<Vec3d, 3> vertex_impulses(const Vec3d& impulse, const Vec3d& place, const Corners& triangle, const std::array<double, 3>& weights);

}  // namespace fccda
