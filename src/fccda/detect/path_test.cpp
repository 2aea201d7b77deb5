#include "fccda/detect/path_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fccda {

namespace {

PathResult nothing(double clearance) { return {.clearance = clearance}; }

}  // namespace

PathTest::PathTest(SharedSurface surface, ContactBounds region, double radius)
    : Relocator(surface->surface(), surface->bvh(), surface->solids()), shared_(std::move(surface)), region_(std::move(region)), radius_(radius) {
  const Vec3d extent = this->surface().report().bounds.size();
  size_ = std::max({extent.x, extent.y, extent.z});
}

bool PathTest::is_inside(const Vec3d& point, double tolerance, double radius) const {
  std::size_t tested = 0;
  const std::optional<ClosestPoint> closest = bvh().closest(point);
  return closest && std::visit([&](const auto& region) { return region.contains(closest->point); }, region_) &&
         too_near(*closest, point, radius - tolerance, tested);
}

bool PathTest::leads_to_contact(const Path& path, const ClosestPoint& at_start, const ClosestPoint& at_end, const Ball& ball, const Bvh::Nearby& nearby,
                                std::size_t& tested) const {
  if (surface().is_closed() && too_near(at_end, path.end, ball.radius - ball.offset, tested)) return true;
  // No point of the path is nearer than half of the difference between the distances at its ends and its length.
  if (at_start.distance + at_end.distance > 2 * ball.radius + path.length() + ball.offset) return false;
  if (ball.radius == 0) return bvh().first_hit(path.start, path.end, nearby, tested).has_value();
  const double limit = ball.radius - ball.offset;
  const std::optional<double> nearest = bvh().distance_to_segment(path.start, path.end, limit, nearby, tested);
  return nearest && *nearest < limit;
}

std::optional<PathTest::Leg> PathTest::first_leg(const CurvedPath& path, const Vec3d& start, const ClosestPoint& at_start, const ClosestPoint& at_end,
                                                 const Ball& ball, const Bvh::Nearby& nearby, std::size_t& tested) const {
  const int parts = path.parts();
  Leg leg{{start, start}, at_start, 0, 1.0 / parts};
  for (int k = 0; k < parts;) {
    // Parts that end before the surface can be near are skipped.
    const double far = (leg.at_start.distance - ball.radius - ball.offset) / path.longest_part();
    const bool skips = parts > 1 && far > 1;
    k += skips ? static_cast<int>(std::min(far, static_cast<double>(parts - k))) : 1;
    leg.path.end = path.place(k);
    ClosestPoint next = at_end;
    if (k < parts) {
      const std::optional<ClosestPoint> found = bvh().closest(leg.path.end, Bvh::no_cap, leg.at_start.triangle, tested);
      if (!found) return std::nullopt;
      next = *found;
    }
    if (!skips && leads_to_contact(leg.path, leg.at_start, next, ball, nearby, tested)) return leg;
    leg = {{leg.path.end, leg.path.end}, next, static_cast<double>(k) / parts, leg.share};
  }
  return std::nullopt;
}

// First contact along the path and a position there: the fallback of relocation.
BodyFrameContact PathTest::first_contact(const Leg& leg, const Ball& ball, const Bvh::Nearby& nearby, std::size_t& tested) const {
  const Path& path = leg.path;
  BodyFrameContact contact{.time_fraction = leg.begin,
                           .hit = leg.at_start.point,
                           .normal = outward(leg.at_start, path.start, ball.offset),
                           .relocation = path.start,
                           .triangle = leg.at_start.triangle};
  // At the radius itself, without the offset: where the path grazes an edge, the normal depends on it.
  const double sharp = 1e-3 * ball.offset;
  const std::optional<Crossing> first = ball.radius == 0 ? bvh().first_hit(path.start, path.end, nearby, tested)
                                                         : bvh().first_contact(path.start, path.end, ball.radius, sharp, leg.at_start.triangle, nearby, tested);
  if (!first) return contact;
  const Vec3d place = path.at(first->fraction);
  const ClosestPoint closest = closest_on(first->triangle, place);
  contact.time_fraction = leg.begin + leg.share * first->fraction;
  contact.hit = closest.point;
  contact.normal = ball.radius == 0 ? surface().normal(static_cast<std::size_t>(first->triangle)) : outward(closest, place, ball.offset);
  contact.relocation = closest.point + (ball.radius + ball.offset) * contact.normal;
  contact.triangle = first->triangle;
  contact.front = side(closest, place, tested) > 0;
  return contact;
}

PathResult PathTest::evaluate(const PathQuery& query, int& guess, Effort& effort) const {
  const Path& path = query.path.chord();
  const double offset = query.offset, reach = query.radius + offset;
  const double path_length = path.length() + query.path.bulge();  // bounds the distance of any point of the path from its ends
  if (!std::isfinite(path_length)) return nothing(0);

  // Far from the contact bounds or from the bounding box of the surface.
  const bool may_contact = std::visit([&](const auto& region) { return region.may_contact(path, reach + query.path.bulge()); }, region_);
  if (!may_contact) return nothing(query.entered ? 0 : std::visit([&](const auto& region) { return region.distance_at_least(path.end); }, region_) - reach);
  ++effort.points_in_bounds;
  const double from_bounds = surface().report().bounds.distance(path.end);
  if (from_bounds > reach + path_length && !query.entered) return nothing(from_bounds - reach);

  ++effort.points_tested;
  std::size_t& tested = effort.panels_tested;
  const double cap = reach + path_length + query.look_ahead;
  Bvh::Nearby nearby;  // contains the start, and usually the relocated position
  const std::optional<ClosestPoint> at_end = bvh().closest(path.end, cap, guess, 2 * path_length + 4 * offset, nearby, tested);
  const bool clips = std::visit([](const auto& region) { return region.clips(); }, region_);
  const bool comes = clips && !std::visit([&](const auto& region) { return region.may_contact({path.start, path.start}, reach); }, region_);
  if (at_end) guess = at_end->triangle;
  if (!comes && !query.entered) {
    if (!at_end) return nothing(cap - reach);
    const bool may_be_deep = surface().is_closed() && side(*at_end, path.end, tested) < 0;
    if (at_end->distance > reach + path_length && !may_be_deep) return nothing(at_end->distance - reach);
  }

  // Near: determine the side of the start.
  const std::optional<ClosestPoint> found = bvh().closest(path.start, nearby, guess, tested);
  if (!found) return nothing(0);
  ClosestPoint at_start = *found;
  PathResult result = nothing(at_end ? at_end->distance - reach : cap - reach);
  bool entered = query.entered;
  const bool starts_near = too_near(at_start, path.start, query.radius - offset, tested);
  if (entered && !starts_near) {
    result.leaves = true;
    entered = false;
  }
  // A start inside without a known cause: the point entered where contact is ignored, through a clipped part of a closed surface or round the
  // boundary of an open one. Within the path length of a step, it is a residue of friction or rounding. If an open surface was in contact
  // with it in the previous step, another impactor pushed it there.
  const auto is_deep = [&] { return too_near(at_start, path.start, query.radius - path_length, tested); };
  const auto came_round = [&] {
    if (surface().is_closed()) return comes || (clips && query.renumbered && is_deep());
    return !query.in_contact && is_deep();
  };
  if (!entered && starts_near && came_round()) {
    result.enters = entered = true;
    result.is_first_entry = comes || !query.renumbered;
  }
  if (entered && surface().is_closed()) {
    result.clearance = 0;
    return result;
  }
  if (entered) result.clearance = 0;
  if (!at_end) return result;

  // An open surface detects balls from its front only; from elsewhere, and for points that came round its boundary, only centre crossings count.
  const bool in_front = surface().is_closed() || side(at_start, path.start, tested) > 0;
  Ball ball{in_front && !entered ? query.radius : 0, offset};
  Vec3d start = path.start;
  if (starts_near && !entered) {  // pinched between impactors: start from the nearest position outside
    if (solids().may_be_buried(at_start.triangle)) at_start = nearest(start, at_start.triangle, tested)->closest;
    start = at_start.point + (ball.radius + offset) * outward(at_start, start, 0.5 * offset);
    at_start.distance = ball.radius + offset;
  }
  std::optional<Leg> leg;
  if (!in_front && !entered && query.radius > 0 && at_start.distance >= query.radius - offset) {
    // The whole ball is clear beside or behind the surface. It may come round to the front, and counts as a ball if it makes contact there first.
    const Ball whole{query.radius, offset};
    leg = first_leg(query.path, start, at_start, *at_end, whole, nearby, tested);
    if (leg && first_contact(*leg, whole, nearby, tested).front)
      ball = whole;
    else
      leg.reset();
  }
  if (!leg) leg = first_leg(query.path, start, at_start, *at_end, ball, nearby, tested);
  if (!leg) return result;

  result.clearance = 0;
  BodyFrameContact contact = first_contact(*leg, ball, nearby, tested);
  if (!std::visit([&](const auto& region) { return region.contains(contact.hit); }, region_)) {
    result.enters = surface().is_closed() && too_near(*at_end, path.end, query.radius - offset, tested);
    return result;
  }
  const Vec3d& from = leg->path.start;
  const Vec3d viewer = from + offset * outward(leg->at_start, from, offset);  // so that a start on the surface faces its own panel
  relocate(contact, path.end, *at_end, {nearby, from, viewer, ball}, tested);
  if (!starts_near && leg->begin == 0) {
    const Vec3d normal = outward(leg->at_start, path.start, offset);
    if (slid_along(normal, leg->at_start.distance, contact, path, ball)) contact.normal_t0 = normal;
  }
  result.contact = contact;
  result.in_contact_as_ball = ball.radius == query.radius;
  return result;
}

}  // namespace fccda
