/// Operations on axis-aligned boxes for contact bounds.
#pragma once

#include <algorithm>
#include <span>

#include "base/vec3.hpp"

namespace fccda {

/// True if two boxes are disjoint. False for not-a-number.
inline bool are_apart(const Box& a, const Box& b) {
  return a.low.x > b.high.x || a.high.x < b.low.x || a.low.y > b.high.y || a.high.y < b.low.y || a.low.z > b.high.z || a.high.z < b.low.z;
}

inline bool contains(const Box& box, const Vec3d& point) {
  return point.x >= box.low.x && point.x <= box.high.x && point.y >= box.low.y && point.y <= box.high.y && point.z >= box.low.z && point.z <= box.high.z;
}

inline bool contains(const Box& box, const Box& other) { return contains(box, other.low) && contains(box, other.high); }

/// [m²], 0 inside
inline double squared_distance(const Box& box, const Vec3d& point) { return squared_norm(max(max(box.low - point, point - box.high), Vec3d{})); }

/// [m³], 0 if empty
inline double volume_of(const Box& box) {
  const Vec3d size = max(box.size(), Vec3d{});
  return size.x * size.y * size.z;
}

inline Box widened(const Box& box, double by) { return {box.low - Vec3d{by, by, by}, box.high + Vec3d{by, by, by}}; }

/// [m³] of the union: the shared volume of boxes counts once.
double volume_of(std::span<const Box> boxes);

/// The bounding box of several boxes.
inline Box bounds_of(std::span<const Box> boxes) {
  Box bounds;
  for (const Box& box : boxes) bounds.include(box.low), bounds.include(box.high);
  return bounds;
}

}  // namespace fccda
