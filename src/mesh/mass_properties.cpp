#include "mesh/mass_properties.hpp"

namespace fccda {

MassProperties mass_properties(const LinkedTriangles& surface) {
  Box bounds;
  for (const Vec3d& vertex : surface.vertices) bounds.include(vertex);
  const Vec3d o = bounds.centre();

  double volume = 0;
  Vec3d first{};                // ∫x dV
  Vec3d squares{}, products{};  // ∫x² dV …, ∫yz dV …
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3d a = surface.corner(t, 0) - o, b = surface.corner(t, 1) - o, c = surface.corner(t, 2) - o;
    const double d = dot(a, cross(b, c));
    const Vec3d s = a + b + c;
    volume += d / 6;
    first += (d / 24) * s;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      squares[i] += d / 120 * (a[i] * a[i] + b[i] * b[i] + c[i] * c[i] + s[i] * s[i]);
      products[i] += d / 120 * (a[j] * a[k] + b[j] * b[k] + c[j] * c[k] + s[j] * s[k]);
    }
  }
  if (volume == 0) return {};

  const Vec3d m = first / volume;  // from o
  for (std::size_t i = 0; i < 3; ++i) {
    squares[i] -= volume * m[i] * m[i];
    products[i] -= volume * m[(i + 1) % 3] * m[(i + 2) % 3];
  }
  return {volume, o + m, {squares.y + squares.z, squares.z + squares.x, squares.x + squares.y}, products};
}

double signed_volume(const LinkedTriangles& surface, std::span<const std::size_t> triangles) {
  if (triangles.empty()) return 0;
  const Vec3d o = surface.corner(triangles[0], 0);
  double volume = 0;
  for (const std::size_t t : triangles) volume += dot(surface.corner(t, 0) - o, cross(surface.corner(t, 1) - o, surface.corner(t, 2) - o)) / 6;
  return volume;
}

}  // namespace fccda
