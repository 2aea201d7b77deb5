#include "fccda/deforming/moving_path_test.hpp"

#include <cmath>

namespace fccda {

namespace {

const Solids no_solids;

PathResult nothing(double clearance) { return {.clearance = clearance}; }

Vec3d at(const Corners& corners, const std::array<double, 3>& weights) { return weights[0] * corners.a + weights[1] * corners.b + weights[2] * corners.c; }

/// Orthonormal axes of a triangle: along its first edge, in its plane, along its normal.
Mat3 axes(const Corners& corners) {
  const Vec3d along = normalised(corners.b - corners.a), normal = normalised(cross(corners.b - corners.a, corners.c - corners.a));
  return {{along, cross(normal, along), normal}};
}

}  // namespace

MovingPathTest::MovingPathTest(const DeformingSurface& surface)
    : surface_(&surface), t0_(surface.at_t0(), surface.bvh_t0(), no_solids), t1_(surface.at_t1(), surface.bvh_t1(), no_solids) {}

// Bound of how far the point moves relative to any point of the surface [m].
double MovingPathTest::way(const Path& path) const { return surface_->spread() + norm(path.end - path.start - surface_->mean_displacement()); }

// The vector as seen from a triangle at a fraction of the step, with the triangle at t1.
Vec3d MovingPathTest::carried(int triangle, double fraction, const Vec3d& vector) const {
  const MovingTriangle moving = surface_->triangle(static_cast<std::size_t>(triangle));
  return transpose(axes(moving.t1)) * (axes(moving.at(fraction)) * vector);
}

std::optional<Crossing> MovingPathTest::first_meeting(const Path& path, double radius, double tolerance, int guess, const Bvh::Nearby& nearby,
                                                      std::size_t& tested) const {
  std::optional<Crossing> first;
  double until = 1;
  const auto consider = [&](int triangle) {
    ++tested;
    const MovingTriangle moving = surface_->triangle(static_cast<std::size_t>(triangle));
    const std::optional<double> fraction = radius == 0 ? front_crossing(path, moving) : fccda::first_contact(path, moving, radius, tolerance, until);
    if (fraction) take_if_first(surface_->at_t1(), {triangle, *fraction}, first, until);
  };
  consider(guess);
  const Bvh::MovingBall ball{path.start, path.end, radius + tolerance, way(path)};
  surface_->bvh_t1().visit_moving(surface_->bvh_t0(), ball, nearby, until, [&](int triangle) {
    if (triangle != guess) consider(triangle);
  });
  return first;
}

bool MovingPathTest::leads_to_contact(const Approach& approach, const Bvh::Nearby& nearby, std::size_t& tested) const {
  const auto& [path, at_start, at_end, ball] = approach;
  if (surface_->at_t1().is_closed() && t1_.too_near(at_end, path.end, ball.radius - ball.offset, tested)) return true;
  // No point of the path is nearer than half of the difference between the distances at its ends and its length.
  if (at_start.distance + at_end.distance > 2 * ball.radius + way(path) + ball.offset) return false;
  if (ball.radius == 0) return first_meeting(path, 0, 0, at_start.triangle, nearby, tested).has_value();
  const double tolerance = 1e-3 * ball.offset;
  return first_meeting(path, ball.radius - ball.offset - tolerance, tolerance, at_start.triangle, nearby, tested).has_value();
}

// First contact, and a position there at t1: the fallback of relocation.
BodyFrameContact MovingPathTest::first_contact(const Approach& approach, const Bvh::Nearby& nearby, std::size_t& tested) const {
  const auto& [path, at_start, at_end, ball] = approach;
  const std::optional<Crossing> first = first_meeting(path, ball.radius, ball.radius == 0 ? 0 : 1e-3 * ball.offset, at_start.triangle, nearby, tested);
  const int triangle = first ? first->triangle : at_start.triangle;
  const double fraction = first ? first->fraction : 0;
  const MovingTriangle moving = surface_->triangle(static_cast<std::size_t>(triangle));
  const Corners corners = moving.at(fraction);
  const Vec3d place = path.at(fraction);
  const PointOnTriangle on = closest_on_triangle(place, corners);
  const Vec3d hit = at(moving.t1, barycentric(corners, place)), line = carried(triangle, fraction, place - on.point);
  const ClosestPoint closest{triangle, on.feature, hit, norm(line)};
  BodyFrameContact contact{.time_fraction = fraction, .hit = hit, .normal = {}, .relocation = {}, .triangle = triangle};
  contact.normal = first && ball.radius == 0 ? surface_->at_t1().normal(static_cast<std::size_t>(triangle)) : t1_.outward(closest, hit + line, ball.offset);
  contact.relocation = first ? hit + (ball.radius + ball.offset) * contact.normal : hit + line;
  contact.front = t1_.side(closest, hit + line, tested) > 0;
  return contact;
}

// Where the surface deforms, the start, carried along with the triangle that was met, may be inside another part of the surface at t1, or behind it.
// The position of first contact is then a better start.
MovingPathTest::CarriedStart MovingPathTest::carried_start(const Approach& approach, const BodyFrameContact& contact, const Bvh::Nearby& nearby,
                                                           std::size_t& tested) const {
  const auto& [path, at_start, at_end, ball] = approach;
  const Bvh& bvh = surface_->bvh_t1();
  const MovingTriangle moving = surface_->triangle(static_cast<std::size_t>(contact.triangle));
  const Vec3d hit_t0 = at(moving.t0, barycentric(moving.t1, contact.hit));
  const Vec3d start = contact.hit + carried(contact.triangle, 0, path.start - hit_t0);
  const std::optional<ClosestPoint> closest = bvh.closest(start, nearby, contact.triangle, tested);
  const bool is_clear = closest && !t1_.too_near(*closest, start, ball.radius - ball.offset, tested);
  if (is_clear && !bvh.first_hit(start, contact.relocation, nearby, tested)) return {start, *closest};
  return {contact.relocation, *bvh.closest(contact.relocation, nearby, contact.triangle, tested)};
}

void MovingPathTest::relocate(BodyFrameContact& contact, const Approach& approach, bool pushed, const Bvh::Nearby& nearby, std::size_t& tested) const {
  const auto& [path, at_start, at_end, ball] = approach;
  const auto [start, closest] = carried_start(approach, contact, nearby, tested);
  const Vec3d viewer = start + ball.offset * t1_.outward(closest, start, ball.offset);  // so that a start on the surface faces its own panel
  t1_.relocate(contact, path.end, at_end, {nearby, start, viewer, ball}, tested);
  if (pushed) return;
  const Vec3d normal = t0_.outward(at_start, path.start, ball.offset);
  if (Relocator::slid_along(carried(at_start.triangle, 0, normal), at_start.distance, contact, {start, path.end}, ball)) contact.normal_t0 = normal;
}

PathResult MovingPathTest::evaluate(const MovingQuery& query, int& guess, Effort& effort) const {
  const Path& path = query.path;
  const double offset = query.offset, reach = query.radius + offset, path_length = way(path);
  if (!std::isfinite(path_length)) return nothing(0);
  const Surface& end = surface_->at_t1();
  const double from_bounds = end.report().bounds.distance(path.end);
  if (from_bounds > reach + path_length && !query.entered) return nothing(from_bounds - reach);

  ++effort.points_in_bounds, ++effort.points_tested;
  std::size_t& tested = effort.panels_tested;
  const double cap = reach + path_length + query.look_ahead;
  Bvh::Nearby nearby;  // contains the start as seen from the surface at t1, and usually the relocated position
  const std::optional<ClosestPoint> at_end = surface_->bvh_t1().closest(path.end, cap, guess, 2 * path_length + 4 * offset, nearby, tested);
  if (at_end) guess = at_end->triangle;
  if (!query.entered) {
    if (!at_end) return nothing(cap - reach);
    const bool may_be_deep = end.is_closed() && t1_.side(*at_end, path.end, tested) < 0;
    if (at_end->distance > reach + path_length && !may_be_deep) return nothing(at_end->distance - reach);
  }

  // Near: determine the side of the start.
  const std::optional<ClosestPoint> found = surface_->bvh_t0().closest_before(path.start, nearby, path_length, guess, tested);
  if (!found) return nothing(0);
  ClosestPoint at_start = *found;
  PathResult result = nothing(at_end ? at_end->distance - reach : cap - reach);
  bool entered = query.entered;
  const bool starts_near = t0_.too_near(at_start, path.start, query.radius - offset, tested);
  if (entered && !starts_near) {
    result.leaves = true;
    entered = false;
  }
  // A start in front of an open surface, without a known cause, by more than the path length: the point came round the boundary.
  const auto is_deep = [&] { return t0_.too_near(at_start, path.start, query.radius - path_length, tested); };
  if (!entered && starts_near && !end.is_closed() && !query.in_contact && is_deep()) {
    result.enters = entered = true;
    result.is_first_entry = !query.renumbered;
  }
  if (entered) result.clearance = 0;
  if (!at_end) return result;

  // An open surface detects balls from its front only; from elsewhere, and for points that came round its boundary, only centre crossings count.
  const bool in_front = end.is_closed() || t0_.side(at_start, path.start, tested) > 0;
  Approach approach{path, at_start, *at_end, {in_front && !entered ? query.radius : 0, offset}};
  if (starts_near && !entered) {  // pinched: start from the nearest position outside
    approach.path.start = at_start.point + (approach.ball.radius + offset) * t0_.outward(at_start, path.start, 0.5 * offset);
    approach.at_start.distance = approach.ball.radius + offset;
  }
  std::optional<BodyFrameContact> contact;
  if (!in_front && !entered && query.radius > 0 && at_start.distance >= query.radius - offset) {
    // The whole ball is clear beside or behind the surface. It may come round to the front, and counts as a ball if it makes contact there first.
    Approach whole = approach;
    whole.ball.radius = query.radius;
    if (leads_to_contact(whole, nearby, tested)) contact = first_contact(whole, nearby, tested);
    if (contact && !contact->front) contact.reset();
    if (contact) approach = whole;
  }
  if (!contact && leads_to_contact(approach, nearby, tested)) contact = first_contact(approach, nearby, tested);
  if (!contact) return result;

  result.clearance = 0;
  relocate(*contact, approach, starts_near, nearby, tested);
  result.contact = contact;
  result.in_contact_as_ball = approach.ball.radius == query.radius;
  return result;
}

}  // namespace fccda
