#include "fccda/detect/path_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fccda {

namespace {

double distance_from_box(const Box& box, const Vec3d& point) { return norm(max(max(box.low - point, point - box.high), Vec3d{})); }

PathAnswer nothing(double clearance) { return {.clearance = clearance}; }

}  // namespace

PathTest::PathTest(std::shared_ptr<const Surface> surface, Region region, double radius)
    : surface_(std::move(surface)), bvh_(*surface_), region_(region), radius_(radius) {
  const Vec3d extent = surface_->report().bounds.size();
  size_ = std::max({extent.x, extent.y, extent.z});
}

// 1 outside, -1 inside (or behind), 0 where it cannot be told: beyond the rim of an open surface.
int PathTest::side(const ClosestPoint& closest, const Vec3d& point) const {
  const auto t = static_cast<std::size_t>(closest.triangle);
  if (!surface_->is_closed() && surface_->is_rim(t, closest.feature)) return 0;
  return dot(point - closest.point, surface_->pseudonormal(t, closest.feature)) < 0 ? -1 : 1;
}

// Unit direction out of the surface at a closest point: along the line to `point`, or the pseudonormal where that line is too short
// to have a direction.
Vec3d PathTest::outward(const ClosestPoint& closest, const Vec3d& point, double tiny) const {
  const Vec3d& normal = surface_->pseudonormal(static_cast<std::size_t>(closest.triangle), closest.feature);
  if (!(closest.distance > tiny)) return normal;
  const Vec3d line = (point - closest.point) / closest.distance;
  return dot(line, normal) < 0 ? -line : line;
}

bool PathTest::too_near(const ClosestPoint& closest, const Vec3d& point, double distance) const {
  if (surface_->is_closed()) return signed_distance(closest, point) < distance;
  return side(closest, point) > 0 && closest.distance < distance;
}

bool PathTest::is_inside(const Vec3d& point, double tolerance) const {
  const std::optional<ClosestPoint> closest = bvh_.closest(point);
  return closest && std::visit([&](const auto& region) { return region.contains(closest->point); }, region_) && too_near(*closest, point, radius_ - tolerance);
}

bool PathTest::leads_to_contact(const Path& path, const ClosestPoint& at_start, const ClosestPoint& at_end, double radius, double offset,
                                std::size_t& asked) const {
  if (surface_->is_closed() && signed_distance(at_end, path.end) < radius - offset) return true;
  // No point of the path is nearer than half of what the distances at its ends leave of its length.
  if (at_start.distance + at_end.distance > 2 * radius + path.length() + offset) return false;
  if (radius == 0) return bvh_.first_hit(path.start, path.end, asked).has_value();
  const double limit = radius - offset;
  const std::optional<double> nearest = bvh_.distance_to_segment(path.start, path.end, limit, asked);
  return nearest && *nearest < limit;
}

// Where the path touches first, and a place there that is outside: the fallback of relocation.
Touch PathTest::first_touch(const Path& path, const ClosestPoint& at_start, double radius, double offset, std::size_t& asked) const {
  Touch touch{
      .time_fraction = 0, .hit = at_start.point, .normal = outward(at_start, path.start, offset), .relocation = path.start, .triangle = at_start.triangle};
  if (radius == 0) {
    if (const std::optional<Crossing> first = bvh_.first_hit(path.start, path.end, asked)) {
      touch.time_fraction = first->fraction;
      touch.hit = path.at(first->fraction);
      touch.normal = surface_->normal(static_cast<std::size_t>(first->triangle));
      touch.relocation = touch.hit + offset * touch.normal;
      touch.triangle = first->triangle;
    }
    return touch;
  }
  // Conservative advancement: no step is longer than the distance that is left, so it never goes past the first touch. Grazing paths
  // would take for ever; what they stop at is a place outside too.
  constexpr int most_steps = 32;
  const double length = path.length();
  const double enough = std::max(offset, 1e-6 * length);
  ClosestPoint closest = at_start;
  for (int step = 0; step < most_steps; ++step) {
    const double gap = closest.distance - radius;
    if (gap <= enough) break;
    const double fraction = touch.time_fraction + gap / length;
    if (!(fraction < 1)) break;
    const Vec3d place = path.at(fraction);
    const std::optional<ClosestPoint> next = bvh_.closest(place, Bvh::no_cap, closest.triangle, asked);
    if (!next || next->distance < radius - offset) break;
    closest = *next;
    touch = {.time_fraction = fraction, .hit = closest.point, .normal = outward(closest, place, offset), .relocation = place, .triangle = closest.triangle};
  }
  return touch;
}

void PathTest::relocate(Touch& touch, const Path& path, const ClosestPoint& at_end, const Vec3d& viewer, double radius, double offset,
                        std::size_t& asked) const {
  Vec3d direction = touch.normal, place = path.end;
  std::optional<ClosestPoint> closest = at_end;
  if (side(at_end, path.end) > 0 && at_end.distance >= radius) {
    // The path ends outside, past an edge or right through a blade. It loses what it went against the normal after first touch: to put
    // it on the surface would pull it back, or round to the far side.
    place -= std::min(0.0, dot(path.end - touch.relocation, direction)) * direction;
  } else {
    closest = bvh_.closest_facing(path.end, viewer, norm(path.end - touch.hit) + radius + offset, asked);
    if (!closest) return;
    direction = outward(*closest, path.end, offset);
    place = closest->point + (radius + offset) * direction;
  }

  // A face's own distance from the place may be too small where another rises beside it. One projection settles a right angle; a wedge
  // of 10° needs about ten, and sharper ones the fallback.
  constexpr int most_projections = 10;
  for (int projection = 0;; ++projection) {
    const std::optional<ClosestPoint> now = bvh_.closest(place, Bvh::no_cap, closest->triangle, asked);
    if (!now) return;
    const double distance = surface_->is_closed() ? signed_distance(*now, place) : now->distance;
    if (distance >= radius - offset) break;
    if (projection == most_projections) return;
    closest = now;
    direction = outward(*closest, place, 0.5 * offset);
    place = closest->point + (radius + offset) * direction;
  }
  if (bvh_.first_hit(path.start, place, asked)) return;
  touch.normal = direction;
  touch.relocation = place;
  touch.triangle = closest->triangle;
}

PathAnswer PathTest::ask(const PathQuestion& question, int& guess, Effort& effort) const {
  Path path = question.path;
  const double offset = question.offset, length = path.length(), reach = radius_ + offset;
  if (!std::isfinite(length)) return nothing(0);

  // Far from the region or from the surface's bounds.
  const bool may_touch = std::visit([&](const auto& region) { return region.may_touch(path, reach); }, region_);
  const double from_region = std::visit([&](const auto& region) { return region.distance_at_least(path.end); }, region_);
  if (!may_touch) return nothing(question.entered ? 0 : from_region - reach);
  ++effort.points_in_region;
  const double from_bounds = distance_from_box(surface_->report().bounds, path.end);
  if (from_bounds > reach + length && !question.entered) return nothing(from_bounds - reach);

  ++effort.points_asked;
  const double cap = reach + length + question.look_ahead;
  const std::optional<ClosestPoint> at_end = bvh_.closest(path.end, cap, guess, effort.panels_asked);
  const bool clips = std::visit([](const auto& region) { return region.clips(); }, region_);
  const bool comes = clips && !std::visit([&](const auto& region) { return region.may_touch({path.start, path.start}, reach); }, region_);
  if (at_end) guess = at_end->triangle;
  if (!comes && !question.entered) {
    if (!at_end) return nothing(cap - reach);
    const bool deep_inside = surface_->is_closed() && side(*at_end, path.end) < 0;
    if (at_end->distance > reach + length && !deep_inside) return nothing(at_end->distance - reach);
  }

  // Near: where does it come from?
  const std::optional<ClosestPoint> found = bvh_.closest(path.start, Bvh::no_cap, guess, effort.panels_asked);
  if (!found) return nothing(0);
  ClosestPoint at_start = *found;
  PathAnswer answer = nothing(at_end ? at_end->distance - reach : cap - reach);
  bool entered = question.entered;
  bool starts_near = too_near(at_start, path.start, radius_ - offset);
  if (entered && !starts_near) {
    answer.leaves = true;
    entered = false;
  }
  // A start inside that nothing explains: it came round through what is not felt, be it another part of a clipped closed surface or the
  // rim of an open one. By less than a step's way it is what friction or rounding left of a contact.
  const bool came_round = surface_->is_closed() ? comes : radius_ - at_start.distance > length;
  if (!entered && starts_near && came_round) answer.enters = entered = true;
  if (entered && surface_->is_closed()) {
    answer.clearance = 0;
    return answer;
  }
  if (entered) answer.clearance = 0;
  if (!at_end) return answer;

  // An open surface is struck from its front; from elsewhere, and by what came round its rim, only where its centre crosses.
  const double radius = surface_->is_closed() || (side(at_start, path.start) > 0 && !entered) ? radius_ : 0;
  if (starts_near && !entered) {  // pinched between impactors: from the nearest place outside
    path.start = at_start.point + (radius + offset) * outward(at_start, path.start, 0.5 * offset);
    at_start.distance = radius + offset;
  }
  if (!leads_to_contact(path, at_start, *at_end, radius, offset, effort.panels_asked)) return answer;

  answer.clearance = 0;
  Touch touch = first_touch(path, at_start, radius, offset, effort.panels_asked);
  if (!std::visit([&](const auto& region) { return region.contains(touch.hit); }, region_)) {
    answer.enters = surface_->is_closed() && too_near(*at_end, path.end, radius_ - offset);
    return answer;
  }
  const Vec3d viewer = path.start + offset * outward(at_start, path.start, offset);  // a start on the surface sees its own panel
  relocate(touch, path, *at_end, viewer, radius, offset, effort.panels_asked);
  answer.touch = touch;
  return answer;
}

}  // namespace fccda
