#include "mesh/remesh/curvature.hpp"

#include <cmath>
#include <numbers>

namespace fccda {
namespace {

double height(const Surface& surface, std::size_t triangle, double edge) {
  const Vec3d& a = surface.corner(triangle, 0);
  return norm(cross(surface.corner(triangle, 1) - a, surface.corner(triangle, 2) - a)) / edge;
}

}  // namespace

Curvature curvature(const Surface& surface) {
  constexpr double crease = std::numbers::pi / 6 * (1 + 1e-9);  // a circle of twelve panels has none
  Curvature out{std::vector<double>(surface.triangles().size(), 0.0), std::vector<std::array<bool, 3>>(surface.triangles().size())};
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d& normal = surface.normal(t);
    const Vec3d u = normalised(surface.corner(t, 1) - surface.corner(t, 0)), v = cross(normal, u);
    double uu = 0, uv = 0, vv = 0;  // of the tensor
    for (std::size_t e = 0; e < 3; ++e) {
      if (surface.neighbour(t, e) < 0) continue;
      const auto beyond = static_cast<std::size_t>(surface.neighbour(t, e));
      const Vec3d edge = surface.corner(t, (e + 1) % 3) - surface.corner(t, e);
      const double length = norm(edge);
      const double angle = std::atan2(dot(cross(normal, surface.normal(beyond)), edge) / length, dot(normal, surface.normal(beyond)));
      out.is_crease[t][e] = std::fabs(angle) > crease;
      if (out.is_crease[t][e]) continue;
      const double across = 2 * angle / (height(surface, t, length) + height(surface, beyond, length));
      const Vec3d d = cross(normal, edge) / length;
      uu += across * dot(d, u) * dot(d, u);
      uv += across * dot(d, u) * dot(d, v);
      vv += across * dot(d, v) * dot(d, v);
    }
    out.largest[t] = std::fabs(0.5 * (uu + vv)) + std::hypot(0.5 * (uu - vv), uv);
  }
  return out;
}

}  // namespace fccda
