#include "mesh/nesting.hpp"

#include <algorithm>
#include <utility>

#include "mesh/ray_crossing.hpp"

namespace fccda {
namespace {

struct Part {
  int component = 0;
  Box bounds;
  std::vector<std::size_t> triangles;
  std::vector<Vec3d> middles;  // of triangles distributed over the part
};

std::vector<Part> closed_parts(const LinkedTriangles& surface, const Components& components, const std::vector<bool>& is_closed) {
  std::vector<Part> parts(components.count);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Part& part = parts[static_cast<std::size_t>(components.of_triangle[t])];
    part.component = components.of_triangle[t];
    part.triangles.push_back(t);
    for (std::size_t c = 0; c < 3; ++c) part.bounds.include(surface.corner(t, c));
  }
  for (Part& part : parts) {
    const std::size_t stride = std::max<std::size_t>(1, part.triangles.size() / 4000);
    for (std::size_t k = 0; k < part.triangles.size(); k += stride) {
      const std::size_t t = part.triangles[k];
      part.middles.push_back((surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3.0);
    }
  }
  std::erase_if(parts, [&](const Part& part) { return !is_closed[static_cast<std::size_t>(part.component)]; });
  return parts;
}

bool box_contains(const Box& outer, const Box& inner) {
  return outer.low.x < inner.low.x && outer.low.y < inner.low.y && outer.low.z < inner.low.z && outer.high.x > inner.high.x && outer.high.y > inner.high.y &&
         outer.high.z > inner.high.z;
}

/// Sweeps over y and keeps only the triangles of `outer` that span the current y: about √n of n, so a hollow body of a million triangles
/// takes half a second. Expects both sorted: centroids by y, triangles by their lowest y.
bool contains(const Part& outer, const Part& inner, const LinkedTriangles& surface) {
  const RayCrossing crosses(surface.vertices, surface.triangles);
  const auto range = [&](std::size_t t) { return std::minmax({surface.corner(t, 0).y, surface.corner(t, 1).y, surface.corner(t, 2).y}); };
  std::vector<std::size_t> active;
  std::size_t next = 0;
  for (const Vec3d& point : inner.middles) {
    for (; next < outer.triangles.size() && range(outer.triangles[next]).first <= point.y; ++next) active.push_back(outer.triangles[next]);
    std::erase_if(active, [&](std::size_t t) { return range(t).second < point.y; });
    bool inside = false;
    for (const std::size_t t : active) inside ^= crosses(point, t) != 0;
    if (!inside) return false;
  }
  return true;
}

}  // namespace

Nesting find_nesting(const LinkedTriangles& surface, const Components& components, const std::vector<bool>& component_is_closed) {
  Nesting nesting{std::vector<int>(components.count, 0), std::vector<int>(components.count, -1)};
  if (components.count < 2) return nesting;
  std::vector<Part> parts = closed_parts(surface, components, component_is_closed);
  for (Part& part : parts) {
    const auto lowest = [&](std::size_t t) { return std::min({surface.corner(t, 0).y, surface.corner(t, 1).y, surface.corner(t, 2).y}); };
    std::sort(part.triangles.begin(), part.triangles.end(), [&](std::size_t a, std::size_t b) { return std::pair(lowest(a), a) < std::pair(lowest(b), b); });
    std::sort(part.middles.begin(), part.middles.end(), [](const Vec3d& a, const Vec3d& b) { return a.y < b.y; });
  }
  std::vector<std::pair<int, int>> contained;  // component, and one that contains it
  // Sorted by x, only parts with overlapping ranges of x are compared.
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return std::pair(a.bounds.low.x, a.component) < std::pair(b.bounds.low.x, b.component); });
  for (std::size_t outer = 0; outer < parts.size(); ++outer) {
    for (std::size_t inner = outer + 1; inner < parts.size() && parts[inner].bounds.low.x < parts[outer].bounds.high.x; ++inner) {
      if (!box_contains(parts[outer].bounds, parts[inner].bounds)) continue;
      if (contains(parts[outer], parts[inner], surface)) contained.emplace_back(parts[inner].component, parts[outer].component);
    }
  }
  for (const auto& [inner, outer] : contained) ++nesting.depth[static_cast<std::size_t>(inner)];
  for (const auto& [inner, outer] : contained) {
    int& container = nesting.container[static_cast<std::size_t>(inner)];
    const auto rank = [&](int component) { return std::pair(-nesting.depth[static_cast<std::size_t>(component)], component); };
    if (container < 0 || rank(outer) < rank(container)) container = outer;
  }
  return nesting;
}

}  // namespace fccda
