#include "mesh/inspect/surface_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fccda {

double median_panel_size(const Surface& surface, const PanelFaces& faces) {
  std::vector<double> sizes;
  for (std::size_t panel = 0; panel < faces.size(); ++panel)
    if (faces[panel].area > 0) sizes.push_back(std::sqrt(faces[panel].area * (surface.panels().panels[panel][3] < 0 ? 2 : 1)));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

Facet coarsest_facet(const Surface& surface) {
  constexpr double intended = std::numbers::pi / 3;
  const auto height = [&](std::size_t t, double edge) {
    return norm(cross(surface.corner(t, 1) - surface.corner(t, 0), surface.corner(t, 2) - surface.corner(t, 0))) / edge;
  };
  Facet coarsest;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    for (std::size_t e = 0; e < 3; ++e) {
      const int beyond = surface.neighbour(t, e);
      if (beyond < 0 || static_cast<std::size_t>(beyond) < t) continue;
      const auto other = static_cast<std::size_t>(beyond);
      const Vec3d a = surface.corner(t, e), b = surface.corner(t, (e + 1) % 3);
      const double angle = std::atan2(norm(cross(surface.normal(t), surface.normal(other))), dot(surface.normal(t), surface.normal(other)));
      if (!(angle < intended)) continue;
      const double width = 0.5 * (height(t, norm(b - a)) + height(other, norm(b - a)));
      if (width * angle / 8 > coarsest.sagitta) coarsest = {width * angle / 8, angle, surface.triangles()[t].panel, 0.5 * (a + b)};
    }
  return coarsest;
}

std::vector<Thickness> thicknesses(const Surface& surface, const Bvh& bvh, std::size_t most) {
  std::vector<Thickness> found;
  if (!surface.is_closed()) return found;
  const std::size_t count = surface.triangles().size(), stride = (count + most - 1) / most;
  const double far = norm(surface.report().bounds.size()), tiny = 1e-9 * far;
  std::size_t tested = 0;
  for (std::size_t t = 0; t < count; t += stride) {
    const Vec3d middle = (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3.0;
    const Vec3d inward = -surface.normal(t);
    // The ray is cast backwards, from far away towards the centroid, where it passes from the front what an inward ray would leave through.
    // The last such crossing is the nearest.
    Vec3d start = middle + far * inward;
    std::optional<double> thickness;
    while (const auto crossing = bvh.first_hit(start, middle, tested)) {
      const Vec3d hit = start + crossing->fraction * (middle - start);
      thickness = norm(hit - middle);
      start = hit - tiny * inward;
      if (!(dot(start - middle, inward) > tiny)) break;
    }
    if (thickness) found.push_back({*thickness, surface.triangles()[t].panel, middle});
  }
  return found;
}

}  // namespace fccda
