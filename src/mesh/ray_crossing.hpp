/// Ray–triangle crossings, for inside–outside tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "mesh/triangle.hpp"

namespace fccda {

/// The crossings of rays along +x with triangles. Edges follow the half-open rule in the plane (y, z), always from the lower vertex number
/// to the higher. So both triangles of an edge evaluate it identically, and no ray passes between them or crosses both. For a point on the
/// surface either result is possible.
class RayCrossing {
 public:
  RayCrossing(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) : vertices_(vertices), triangles_(triangles) {}

  /// 1 where the ray leaves through the back of triangle t, -1 where it enters through its front, 0 where it misses. The sum over closed
  /// outward triangles is the number of bodies that contain `from`.
  int operator()(const Vec3d& from, std::size_t t) const {
    const auto& v = triangles_[t].vertex;
    bool meets = false;
    for (std::size_t e = 0; e < 3; ++e) meets ^= edge_is_above(from, v[e], v[(e + 1) % 3]);
    if (!meets) return 0;
    const Vec3d& a = at(v[0]);
    const Vec3d normal = cross(at(v[1]) - a, at(v[2]) - a);
    if (!(dot(normal, a - from) * normal.x > 0)) return 0;
    return normal.x > 0 ? 1 : -1;
  }

 private:
  const Vec3d& at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }

  bool edge_is_above(const Vec3d& p, int one, int other) const {
    const auto [low, high] = std::minmax(one, other);
    const Vec3d& a = at(low);
    const Vec3d& b = at(high);
    if ((a.y > p.y) == (b.y > p.y)) return false;
    return ((b.z - a.z) * (p.y - a.y) - (p.z - a.z) * (b.y - a.y) > 0) == (b.y > a.y);
  }

  std::span<const Vec3d> vertices_;
  std::span<const Triangle> triangles_;
};

}  // namespace fccda
