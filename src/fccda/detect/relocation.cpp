// Where a point that touches is put.
#include <algorithm>
#include <cmath>

#include "fccda/detect/path_test.hpp"

namespace fccda {

// Unit direction out of the surface at a closest point: along the line to `point`, or the pseudonormal where that line is too short
// to have a direction.
Vec3d PathTest::outward(const ClosestPoint& closest, const Vec3d& point, double tiny) const {
  const Vec3d& normal = surface_->pseudonormal(static_cast<std::size_t>(closest.triangle), closest.feature);
  if (!(closest.distance > tiny)) return normal;
  const Vec3d line = (point - closest.point) / closest.distance;
  return dot(line, normal) < 0 ? -line : line;
}

std::optional<PathTest::Nearest> PathTest::nearest(const Vec3d& point, const Bvh::Nearby& nearby, int guess, std::size_t& asked) const {
  const std::optional<ClosestPoint> closest = bvh_.closest(point, nearby, guess, asked);
  if (!closest) return std::nullopt;
  if (!surface_->is_closed()) return Nearest{*closest, closest->distance};
  if (!solids_.may_be_buried(closest->triangle)) return Nearest{*closest, side(*closest, point, asked) * closest->distance};
  const std::optional<Solids::Nearest> deepest = solids_.nearest(point, asked);
  return Nearest{deepest->closest, deepest->signed_distance};
}

// The closest point among the triangles that face the viewer; of overlapping solids only on the one that `closest` belongs to, for its
// neighbours' triangles may lie buried in it.
std::optional<ClosestPoint> PathTest::closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, const ClosestPoint& closest,
                                                     std::size_t& asked) const {
  if (!solids_.several()) return bvh_.closest_facing(point, viewer, cap, asked);
  return solids_.closest_facing(surface_->solid_of(static_cast<std::size_t>(closest.triangle)), point, viewer, cap, asked);
}

// Where the path touches first, and a place there that is outside: the fallback of relocation.
Touch PathTest::first_touch(const Leg& leg, const Ball& ball, std::size_t& asked) const {
  const Path& path = leg.path;
  Touch touch{.time_fraction = leg.begin,
              .hit = leg.at_start.point,
              .normal = outward(leg.at_start, path.start, ball.offset),
              .relocation = path.start,
              .triangle = leg.at_start.triangle};
  if (ball.radius == 0) {
    if (const std::optional<Crossing> first = bvh_.first_hit(path.start, path.end, asked)) {
      touch.time_fraction = leg.begin + leg.share * first->fraction;
      touch.hit = path.at(first->fraction);
      touch.normal = surface_->normal(static_cast<std::size_t>(first->triangle));
      touch.relocation = touch.hit + ball.offset * touch.normal;
      touch.triangle = first->triangle;
    }
    return touch;
  }
  // Conservative advancement: no step is longer than the distance that is left, so it never goes past the first touch. Grazing paths
  // would take for ever; what they stop at is a place outside too.
  constexpr int most_steps = 32;
  const double length = path.length();
  const double enough = std::max(ball.offset, 1e-6 * length);
  ClosestPoint closest = leg.at_start;
  double fraction = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double gap = closest.distance - ball.radius;
    if (gap <= enough) break;
    fraction += gap / length;
    if (!(fraction < 1)) break;
    const Vec3d place = path.at(fraction);
    const std::optional<ClosestPoint> next = bvh_.closest(place, Bvh::no_cap, closest.triangle, asked);
    if (!next || next->distance < ball.radius - ball.offset) break;
    closest = *next;
    touch = {.time_fraction = leg.begin + leg.share * fraction,
             .hit = closest.point,
             .normal = outward(closest, place, ball.offset),
             .relocation = place,
             .triangle = closest.triangle};
  }
  return touch;
}

void PathTest::relocate(Touch& touch, const Path& path, const ClosestPoint& at_end, const Bvh::Nearby& nearby, const Vec3d& viewer, const Ball& ball,
                        std::size_t& asked) const {
  const double reach = ball.radius + ball.offset;
  Vec3d direction = touch.normal, place = path.end;
  ClosestPoint closest = at_end;
  if (side(at_end, path.end, asked) > 0 && at_end.distance >= ball.radius) {
    // The path ends outside, past an edge or right through a blade. It loses what it went against the normal after first touch: to put
    // it on the surface would pull it back, or round to the far side.
    place -= std::min(0.0, dot(path.end - touch.relocation, direction)) * direction;
  } else {
    if (solids_.may_be_buried(at_end.triangle)) closest = nearest(path.end, at_end.triangle, asked)->closest;
    const auto t = static_cast<std::size_t>(closest.triangle);
    if (!(dot(viewer - surface_->corner(t, 0), surface_->normal(t)) > 0)) {  // else nothing that faces the start is closer
      const std::optional<ClosestPoint> facing = closest_facing(path.end, viewer, norm(path.end - touch.hit) + reach, closest, asked);
      if (!facing) return;
      closest = *facing;
    }
    direction = outward(closest, path.end, ball.offset);
    place = closest.point + reach * direction;
  }

  // A face's own distance from the place may be too small where another rises beside it. One projection settles a right angle; a wedge
  // of 10° needs about ten, and sharper ones the fallback.
  constexpr int most_projections = 10;
  for (int projection = 0;; ++projection) {
    const std::optional<Nearest> now = nearest(place, nearby, closest.triangle, asked);
    if (!now) return;
    if (now->distance >= ball.radius + 0.5 * ball.offset) break;
    if (projection == most_projections) return;
    closest = now->closest;
    if (now->distance < 0 && solids_.several()) {  // inside another solid: not out at the far side of a thin one
      if (const std::optional<ClosestPoint> facing = closest_facing(place, viewer, Bvh::no_cap, closest, asked)) closest = *facing;
    }
    direction = outward(closest, place, 0.5 * ball.offset);
    place = closest.point + reach * direction;
  }
  if (bvh_.first_hit(path.start, place, asked)) return;
  touch.normal = direction;
  touch.relocation = place;
  touch.triangle = closest.triangle;
}

}  // namespace fccda
