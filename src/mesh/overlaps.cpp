#include "mesh/overlaps.hpp"

#include <algorithm>
#include <vector>

namespace fccda {

std::size_t components_that_may_overlap(const LinkedTriangles& surface, const Components& components) {
  struct Part {
    Box bounds;
    double volume = 0;
    bool meets_another = false;
  };
  if (components.count < 2) return 0;
  std::vector<Part> parts(components.count);
  const Vec3d o = surface.vertices.front();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Part& part = parts[static_cast<std::size_t>(components.of_triangle[t])];
    for (std::size_t c = 0; c < 3; ++c) part.bounds.include(surface.corner(t, c));
    part.volume += dot(surface.corner(t, 0) - o, cross(surface.corner(t, 1) - o, surface.corner(t, 2) - o));
  }
  std::erase_if(parts, [](const Part& part) { return part.volume <= 0; });

  // Sorted by x, only parts with overlapping ranges of x are compared.
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.bounds.low.x < b.bounds.low.x; });
  for (std::size_t a = 0; a < parts.size(); ++a) {
    for (std::size_t b = a + 1; b < parts.size() && parts[b].bounds.low.x < parts[a].bounds.high.x; ++b) {
      const Box &one = parts[a].bounds, &other = parts[b].bounds;
      const bool meet = one.low.y < other.high.y && other.low.y < one.high.y && one.low.z < other.high.z && other.low.z < one.high.z;
      if (meet) parts[a].meets_another = parts[b].meets_another = true;
    }
  }
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](const Part& part) { return part.meets_another; }));
}

}  // namespace fccda
