#include "mesh/polygon.hpp"

namespace fccda {

Polygon part_of(const Polygon& polygon, Side side, std::size_t axis, double at) {
  // signed distance of a corner to the wanted side
  const auto within = [&](const Vec3d& corner) { return side == Side::below ? at - corner[axis] : corner[axis] - at; };
  Polygon part;
  part.reserve(polygon.size() + 1);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d& one = polygon[k];
    const Vec3d& next = polygon[(k + 1) % polygon.size()];
    const double w = within(one), w_next = within(next);
    if (w >= 0) part.push_back(one);
    if ((w > 0 && w_next < 0) || (w < 0 && w_next > 0)) {
      // Always from the lower side, so that both parts get the same corner.
      const Vec3d& low = one[axis] < next[axis] ? one : next;
      const Vec3d& high = one[axis] < next[axis] ? next : one;
      Vec3d corner = low + ((at - low[axis]) / (high[axis] - low[axis])) * (high - low);
      corner[axis] = at;
      part.push_back(corner);
    }
  }
  return part;
}

Box bounds_of(const Polygon& polygon) {
  Box bounds;
  for (const Vec3d& corner : polygon) bounds.include(corner);
  return bounds;
}

}  // namespace fccda
