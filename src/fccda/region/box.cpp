#include "fccda/region/box.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "fccda/core/error.hpp"

namespace fccda {

namespace {

/// How far the point lies beyond the box's faces [m]; not above 0 inside.
double beyond_faces(const Box& box, const Vec3d& point) {
  const Vec3d below = box.low - point, above = point - box.high;
  return std::max({below.x, below.y, below.z, above.x, above.y, above.z});
}

std::string named(const std::set<int>& panels) {
  constexpr std::size_t shown = 5;
  std::ostringstream text;
  std::size_t count = 0;
  for (const int panel : panels) {
    if (count == shown) break;
    text << (count++ > 0 ? ", " : "") << panel;
  }
  if (panels.size() > shown) text << ", ...";
  return text.str();
}

}  // namespace

BoxRegion::BoxRegion(const Shape& shape, const Surface& surface, Beyond beyond) {
  // A vertex that the deck means to lie on a face of the box may be off it by the rounding of its coordinates.
  const Box& bounds = surface.report().bounds;
  const double rounding = 1e-12 * std::max({largest_magnitude(bounds.low), largest_magnitude(bounds.high), largest_magnitude(shape.size)});
  box_.low = shape.centre - 0.5 * shape.size - Vec3d{rounding, rounding, rounding};
  box_.high = shape.centre + 0.5 * shape.size + Vec3d{rounding, rounding, rounding};

  std::set<int> out;
  double furthest = 0;
  bool reached = false;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    Box its;
    for (std::size_t c = 0; c < 3; ++c) {
      its.include(surface.corner(t, c));
      const double distance = beyond_faces(box_, surface.corner(t, c));
      if (distance <= 0) continue;
      out.insert(surface.triangles()[t].panel);
      furthest = std::max(furthest, distance);
    }
    reached = reached || (its.low.x <= box_.high.x && its.high.x >= box_.low.x && its.low.y <= box_.high.y && its.high.y >= box_.low.y &&
                          its.low.z <= box_.high.z && its.high.z >= box_.low.z);
  }
  if (!reached) throw InputError("region: no panel of the surface reaches into the box, so nothing can be struck; check the box's centre and size.");
  clips_ = !out.empty();
  if (!clips_ || beyond == Beyond::clip) return;
  std::ostringstream text;
  text << "region: " << out.size() << " of " << surface.report().panels << " panels stick out of the box by up to " << furthest << " m (panels " << named(out)
       << "), and contact there would be missed; enlarge the box, or say `outside: clip` if it is meant.";
  throw InputError(text.str());
}

bool BoxRegion::contains(const Vec3d& point) const { return beyond_faces(box_, point) <= 0; }

bool BoxRegion::may_touch(const Path& path, double margin) const {
  const Vec3d low = min(path.start, path.end), high = max(path.start, path.end);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low[axis] > box_.high[axis] + margin || high[axis] < box_.low[axis] - margin) return false;
  return true;
}

double BoxRegion::distance_at_least(const Vec3d& point) const { return norm(max(max(box_.low - point, point - box_.high), Vec3d{})); }

}  // namespace fccda
