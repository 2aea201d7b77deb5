#include "fccda/deforming/vertex_impulse.hpp"

namespace fccda {

std::array<Vec3d, 3> vertex_impulses(const Vec3d& impulse, const Vec3d& place, const Corners& triangle, const std::array<double, 3>& weights) {
  const std::array<Vec3d, 3> x{triangle.a, triangle.b, triangle.c};
  const Vec3d area = cross(x[1] - x[0], x[2] - x[0]), normal = normalised(area), centroid = (x[0] + x[1] + x[2]) / 3;
  const Vec3d foot = x[0] + weights[1] * (x[1] - x[0]) + weights[2] * (x[2] - x[0]);
  const Vec3d couple = cross(place - foot, impulse), q = cross(normal, couple);
  double inertia = 0;  // of unit masses about the normal
  for (const Vec3d& corner : x) inertia += squared_norm(corner - centroid);
  const double spin = inertia > 0 ? dot(couple, normal) / inertia : 0;
  std::array<Vec3d, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d opposite = x[(k + 2) % 3] - x[(k + 1) % 3];
    const double slope = squared_norm(area) > 0 ? dot(cross(area, opposite), q) / squared_norm(area) : 0;  // ∇w_k·q
    out[k] = weights[k] * impulse + slope * normal + spin * cross(normal, x[k] - centroid);
  }
  return out;
}

}  // namespace fccda
