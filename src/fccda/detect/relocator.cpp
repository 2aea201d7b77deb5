// Relocation of points in contact, outside the surface.
#include "fccda/detect/relocator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fccda/detect/half_spaces.hpp"

namespace fccda {

int Relocator::side(const ClosestPoint& closest, const Vec3d& point, std::size_t& tested) const {
  const auto t = static_cast<std::size_t>(closest.triangle);
  if (!surface_->is_closed() && surface_->is_boundary_edge(t, closest.feature)) return 0;
  if (dot(point - closest.point, surface_->pseudonormal(t, closest.feature)) < 0) return -1;
  return solids_->may_be_buried(closest.triangle) && solids_->another_holds(closest.triangle, point, tested) ? -1 : 1;
}

bool Relocator::too_near(const ClosestPoint& closest, const Vec3d& point, double distance, std::size_t& tested) const {
  if (surface_->is_closed()) return closest.distance < distance || side(closest, point, tested) * closest.distance < distance;
  return side(closest, point, tested) > 0 && closest.distance < distance;
}

Vec3d Relocator::outward(const ClosestPoint& closest, const Vec3d& point, double tiny) const {
  const Vec3d normal = surface_->pseudonormal(static_cast<std::size_t>(closest.triangle), closest.feature);
  if (!(closest.distance > tiny)) return normal;
  const Vec3d line = (point - closest.point) / closest.distance;
  return dot(line, normal) < 0 ? -line : line;
}

std::optional<Relocator::Nearest> Relocator::nearest(const Vec3d& point, const Bvh::Nearby& nearby, int guess, std::size_t& tested) const {
  const std::optional<ClosestPoint> closest = bvh_->closest(point, nearby, guess, tested);
  if (!closest) return std::nullopt;
  if (!surface_->is_closed()) return Nearest{*closest, closest->distance};
  if (!solids_->may_be_buried(closest->triangle)) return Nearest{*closest, side(*closest, point, tested) * closest->distance};
  const std::optional<Solids::Nearest> deepest = solids_->nearest(point, tested);
  return Nearest{deepest->closest, deepest->signed_distance};
}

// The closest point among the triangles that face the viewer. Of overlapping solids only the one that `closest` belongs to is searched, since
// triangles of the others may be buried in it.
std::optional<ClosestPoint> Relocator::closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, const ClosestPoint& closest,
                                                      std::size_t& tested) const {
  if (!solids_->several()) return bvh_->closest_facing(point, viewer, cap, tested);
  return solids_->closest_facing(surface_->solid_of(static_cast<std::size_t>(closest.triangle)), point, viewer, cap, tested);
}

ClosestPoint Relocator::closest_on(int triangle, const Vec3d& point) const {
  const auto t = static_cast<std::size_t>(triangle);
  const PointOnTriangle on = closest_on_triangle(point, {surface_->corner(t, 0), surface_->corner(t, 1), surface_->corner(t, 2)});
  return {triangle, on.feature, on.point, norm(point - on.point)};
}

// Relocation candidate for the end of the path; it may still penetrate other parts of the surface.
std::optional<Relocator::Place> Relocator::first_place(const BodyFrameContact& contact, const Vec3d& end, const ClosestPoint& at_end, const Around& around,
                                                       std::size_t& tested) const {
  const Ball& ball = around.ball;
  const double reach = ball.radius + ball.offset;
  if (side(at_end, end, tested) > 0 && at_end.distance >= ball.radius) {
    // The path ends outside, past an edge or on the far side of a blade. Only its motion against the normal after first contact is removed:
    // projection onto the surface would pull the point back, or round to the far side.
    const Vec3d& normal = contact.normal;
    return Place{end - std::min(0.0, dot(end - contact.relocation, normal)) * normal, normal, at_end.triangle};
  }
  ClosestPoint closest = at_end;
  if (solids_->may_be_buried(at_end.triangle)) closest = nearest(end, at_end.triangle, tested)->closest;
  const auto t = static_cast<std::size_t>(closest.triangle);
  if (!(dot(around.viewer - surface_->corner(t, 0), surface_->normal(t)) > 0)) {  // else no triangle that faces the start is closer
    const std::optional<ClosestPoint> facing = closest_facing(end, around.viewer, norm(end - contact.hit) + reach, closest, tested);
    if (!facing) return std::nullopt;
    closest = *facing;
  }
  const Vec3d direction = outward(closest, end, ball.offset);
  return Place{closest.point + reach * direction, direction, closest.triangle};
}

// Moves a position out until it is clear of the whole surface; at the offset from one face it may still be too close to an adjacent one. At a
// right angle one projection suffices. In narrower corners the closest features are treated as planes, one more per projection, and the result is
// the admissible position nearest to `wanted`: in a wedge, however sharp, on the line along its edge; in the tip of a funnel on three of its
// faces.
std::optional<Relocator::Place> Relocator::clear_place(Place place, const Vec3d& wanted, const Around& around, std::size_t& tested) const {
  constexpr std::size_t most_projections = 16;
  const Ball& ball = around.ball;
  const double reach = ball.radius + ball.offset;
  const double furthest = norm(around.start - wanted) + 2 * reach;  // the start itself is clear
  HalfSpaces<most_projections + 1> before;
  for (std::size_t projection = 0;; ++projection) {
    const std::optional<Nearest> now = nearest(place.point, around.nearby, place.triangle, tested);
    if (!now) return std::nullopt;
    if (now->distance >= ball.radius + 0.5 * ball.offset) break;
    if (projection == most_projections) return std::nullopt;
    ClosestPoint closest = now->closest;
    if (now->distance < 0 && solids_->several()) {  // inside another solid: avoid leaving a thin one at its far side
      if (const std::optional<ClosestPoint> facing = closest_facing(place.point, around.viewer, Bvh::no_cap, closest, tested)) closest = *facing;
    }
    if (projection == 0 && norm(place.point - wanted) > 0) before.add(place.direction, dot(place.direction, place.point));
    place.direction = outward(closest, place.point, 0.5 * ball.offset);
    place.triangle = closest.triangle;
    // along the normal of the face, which is exact at any distance
    const Vec3d upright = closest.feature == Feature::face ? surface_->normal(static_cast<std::size_t>(closest.triangle)) : place.direction;
    before.add(upright, dot(upright, closest.point) + reach);
    place.point = closest.point + reach * place.direction;
    if (projection == 0) continue;
    const std::optional<Vec3d> common = before.nearest(wanted, 0.25 * ball.offset);
    if (common && norm(*common - wanted) <= furthest) place.point = *common;
  }
  if (bvh_->first_hit(around.start, place.point, around.nearby, tested)) return std::nullopt;
  return place;
}

// Such a ball is relocated along the normal at the end, which has rotated along the path, as round an edge, or not at all. Where the surface
// rises ahead of it, it makes first contact with another part.
bool Relocator::slid_along(const Vec3d& normal, double distance, const BodyFrameContact& contact, const Path& path, const Ball& ball) {
  constexpr double in_contact = 0.01;  // of the path length: clearance that relocation, sliding and rounding leave
  constexpr double rounding = 1e-6, most_turned = 0.5;
  if (ball.radius == 0 || distance > ball.radius + ball.offset + in_contact * path.length()) return false;
  const Vec3d travel = contact.relocation - path.start, push = contact.relocation - path.end;
  if (dot(normal, contact.normal) < most_turned || dot(contact.normal - normal, travel) < -rounding * norm(travel)) return false;
  return !(norm(push - dot(push, contact.normal) * contact.normal) > rounding * norm(push) + 0.1 * ball.offset);
}

void Relocator::relocate(BodyFrameContact& contact, const Vec3d& end, const ClosestPoint& at_end, const Around& around, std::size_t& tested) const {
  std::optional<Place> place = first_place(contact, end, at_end, around, tested);
  if (place) place = clear_place(*place, end, around, tested);
  if (!place) place = clear_place({contact.relocation, contact.normal, contact.triangle}, contact.relocation, around, tested);
  if (!place) place = clear_place({around.start, contact.normal, contact.triangle}, around.start, around, tested);
  if (!place) place = Place{around.start, contact.normal, contact.triangle};
  contact.normal = place->direction;
  contact.relocation = place->point;
  contact.triangle = place->triangle;
}

Vec3d Relocator::slide(const Vec3d& from, const Vec3d& to, double radius, double offset) const {
  constexpr std::size_t max_parts = 8;
  std::size_t tested = 0;
  const Vec3d total = to - from;
  const double way = norm(total);
  Bvh::Nearby nearby;  // of all parts of the way, which stays in the ball of radius `way` about its beginning
  const std::optional<ClosestPoint> at_start = bvh_->closest(from, radius + offset + way, -1, way + 4 * offset, nearby, tested);
  if (!at_start) return to;
  // A ball that entered from behind an open surface is treated as a point until it has clearance.
  const bool is_point = radius > 0 && !surface_->is_closed() && at_start->distance <= radius - offset;
  const double clearance = (is_point ? 0 : radius) + 0.5 * offset;
  std::array<Vec3d, max_parts> walls;
  Vec3d place = from, direction = total;
  double left = 1;
  for (std::size_t part = 0; part < max_parts; ++part) {
    const Vec3d end = part == 0 ? to : place + left * direction;
    const std::optional<Crossing> contact = bvh_->first_contact(place, end, clearance, 0.1 * offset, -1, nearby, tested);
    const Vec3d reached = contact ? place + contact->fraction * (end - place) : end;
    // At one offset from an edge, rounding leaves the direction undefined: a path into the edge may be taken for one along it.
    if (reached != place && bvh_->distance_to_segment(place, reached, clearance - 0.25 * offset, nearby, tested)) return place;
    if (!contact) return end;
    place = reached;
    left *= 1 - contact->fraction;

    const ClosestPoint on = closest_on(contact->triangle, place);
    Vec3d& wall = walls[part];
    wall = place - on.point;
    if (on.feature == Feature::face) {
      const Vec3d normal = surface_->normal(static_cast<std::size_t>(on.triangle));
      wall = dot(wall, normal) < 0 ? -normal : normal;
    }
    if (!(squared_norm(wall) > 0)) return place;
    wall = normalised(wall);

    // Along the wall, or along its edge with an earlier wall that this direction would enter. Anything else is a corner.
    const double into = -1e-12 * way;
    direction = total - dot(total, wall) * wall;
    const auto leads_into = [&](const Vec3d& other) { return dot(direction, other) < into; };
    const auto earlier = std::find_if(walls.begin(), walls.begin() + static_cast<std::ptrdiff_t>(part), leads_into);
    if (earlier != walls.begin() + static_cast<std::ptrdiff_t>(part)) {
      const Vec3d edge = cross(*earlier, wall);
      if (!(squared_norm(edge) > 1e-20)) return place;
      direction = (dot(total, edge) / squared_norm(edge)) * edge;
      if (std::any_of(walls.begin(), walls.begin() + static_cast<std::ptrdiff_t>(part), leads_into)) return place;
    }
    if (!(left * norm(direction) > offset)) return place;
  }
  return place;
}

}  // namespace fccda
