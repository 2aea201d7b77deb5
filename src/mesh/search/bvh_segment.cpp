// Queries along a segment: what it crosses, and what a ball that moves along it meets.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "mesh/ray_crossing.hpp"
#include "mesh/search/bvh.hpp"

namespace fccda {

// Calls visit(leaf) for leaves whose box, enlarged by `margin`, intersects the first `until` of the segment, about in the order in which it enters
// them. Both may shrink meanwhile.
template <class Visit>
void Bvh::visit_segment(const Vec3d& start, const Vec3d& end, const double& until, const double& margin, const Visit& visit) const {
  const Vec3d from = start - origin_, displacement = end - start;
  // A zero component of the direction gets a slope so steep that the segment is inside the slab always or never.
  const auto slope = [](double w) { return std::fabs(w) > 1e-300 ? 1 / w : 1e300; };
  const Vec3d steep{slope(displacement.x), slope(displacement.y), slope(displacement.z)};

  std::array<Pending, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Pending next = stack[--depth];
    if (next.enter > until) continue;
    if (next.child < 0) {
      Leaf room;
      visit(current_leaf(~next.child, room));
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(next.child)];
    std::array<double, width> enter;
    unsigned meets = 0;
#pragma omp simd reduction(| : meets)
    for (std::size_t c = 0; c < width; ++c) {
      double first = 0, last = until;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = (static_cast<double>(node.low[axis][c]) - margin - from[axis]) * steep[axis];
        const double b = (static_cast<double>(node.high[axis][c]) + margin - from[axis]) * steep[axis];
        const double near = a < b ? a : b, far = a < b ? b : a;
        first = first > near ? first : near;
        last = last < far ? last : far;
      }
      enter[c] = first;
      meets |= (first <= last && node.low[0][c] <= node.high[0][c] ? 1u : 0u) << c;
    }
    push(stack, depth, enter, meets, node);
  }
}

// The same from cached surroundings, where they have all of these leaves.
template <class Visit>
void Bvh::visit_near_segment(const Vec3d& start, const Vec3d& end, const double& until, const double& margin, const Nearby& nearby, const Visit& visit) const {
  if (!nearby.covers(margin + std::max(norm(start - nearby.centre), norm(end - nearby.centre)))) return visit_segment(start, end, until, margin, visit);
  Leaf room;
  for (std::size_t k = 0; k < nearby.count; ++k) visit(current_leaf(nearby.leaves[k], room));
}

// Upper bound of the coordinates that a query computes with [m].
double Bvh::scale_of(const Vec3d& start, const Vec3d& end) const {
  const Box& bounds = surface_->report().bounds;
  return std::max({largest_magnitude(start), largest_magnitude(end), largest_magnitude(bounds.low), largest_magnitude(bounds.high)});
}

// The triangles of a leaf, as bits, that front_crossing() may find crossed. Positions relative to the origin of the tree are rounded otherwise than
// there: by less than 4 ε scale each, so that heights and edge terms differ by less than these bounds, with the rounding of both computations.
unsigned Bvh::may_cross(const Leaf& leaf, const Vec3d& from, const Vec3d& to, double scale) {
  const double position = 64 * std::numeric_limits<double>::epsilon() * scale;
  const Vec3d back = from - to;
  const double edge = 8 * position * scale * (std::fabs(back.x) + std::fabs(back.y) + std::fabs(back.z) + position);
  unsigned may = 0;
#pragma omp simd reduction(| : may)
  for (std::size_t l = 0; l < width; ++l) {
    const double abx = leaf.ab[0][l], aby = leaf.ab[1][l], abz = leaf.ab[2][l];
    const double acx = leaf.ac[0][l], acy = leaf.ac[1][l], acz = leaf.ac[2][l];
    const double nx = aby * acz - abz * acy, ny = abz * acx - abx * acz, nz = abx * acy - aby * acx;
    const double ax = leaf.a[0][l] - from.x, ay = leaf.a[1][l] - from.y, az = leaf.a[2][l] - from.z;
    const double bx = ax + abx, by = ay + aby, bz = az + abz, cx = ax + acx, cy = ay + acy, cz = az + acz;
    const double before = -(ax * nx + ay * ny + az * nz), after = before - (back.x * nx + back.y * ny + back.z * nz);
    const double height = position * (std::fabs(nx) + std::fabs(ny) + std::fabs(nz));
    const double u = back.x * (by * cz - bz * cy) + back.y * (bz * cx - bx * cz) + back.z * (bx * cy - by * cx);
    const double v = back.x * (cy * az - cz * ay) + back.y * (cz * ax - cx * az) + back.z * (cx * ay - cy * ax);
    const double w = back.x * (ay * bz - az * by) + back.y * (az * bx - ax * bz) + back.z * (ax * by - ay * bx);
    const bool out = before < -height || after > height || u < -edge || v < -edge || w < -edge;
    may |= (out ? 0u : 1u) << l;
  }
  return may & ((1u << leaf.count) - 1);
}

// The triangles of a leaf, as bits, that may come within `distance` [m] of the point. The margins are far above the rounding of distances, except
// for slivers, whose normals are uncertain: those always may.
unsigned Bvh::may_be_within(const Leaf& leaf, const Vec3d& point, double distance, double scale) {
  constexpr double sliver = 1e12;  // squared: of an angle of 1e-6
  const double limit = (1 + 1e-6) * distance + 1e-7 * scale;
  const std::array<double, width> squared = squared_distances(leaf, point);
  unsigned may = 0;
#pragma omp simd reduction(| : may)
  for (std::size_t l = 0; l < width; ++l) {
    const bool out = squared[l] > limit * limit && leaf.inverse_normal[l] < sliver * leaf.inverse_ab[l] * leaf.inverse_ca[l];
    may |= (out ? 0u : 1u) << l;
  }
  return may & ((1u << leaf.count) - 1);
}

// The triangles of a leaf, as bits, that the ball may meet in the first `until` of the step: those that are, in its middle, no farther away than the
// ball moves in half of it. Points meet so few that it would not pay off.
unsigned Bvh::may_meet(const Bvh& at_t0, std::int32_t leaf, const MovingBall& ball, double until) const {
  const Leaf& at_t1 = leaves_[static_cast<std::size_t>(leaf)];
  if (ball.radius == 0) return (1u << at_t1.count) - 1;
  Leaf room;
  const double middle = 0.5 * until, left = 1 - middle;
  const Vec3d centre = left * ball.start + middle * ball.end;
  room.count = at_t1.count;
  set_corners(room, centre, [&](std::size_t k) {
    const auto t = static_cast<std::size_t>(at_t1.triangle[k / 3]);
    return left * at_t0.surface_->corner(t, k % 3) + middle * surface_->corner(t, k % 3);
  });
  return may_be_within(room, {}, ball.radius + middle * ball.way, std::max(scale_of(ball.start, ball.end), at_t0.scale_of(ball.start, ball.end)));
}

void take_if_first(const Surface& surface, const Crossing& found, std::optional<Crossing>& first, double& until) {
  const auto rank = [&](const Crossing& one) {
    return std::tuple(one.fraction, surface.triangles()[static_cast<std::size_t>(one.triangle)].panel, one.triangle);
  };
  if (first && rank(found) >= rank(*first)) return;
  first = found;
  until = found.fraction;
}

std::optional<Crossing> Bvh::first_hit(const Vec3d& start, const Vec3d& end, const Nearby& nearby, std::size_t& tested) const {
  std::optional<Crossing> first;
  if (!is_finite(start) || !is_finite(end)) return first;
  double until = 1;
  const double margin = 0;
  const double scale = scale_of(start, end);
  visit_near_segment(start, end, until, margin, nearby, [&](const Leaf& leaf) {
    tested += static_cast<std::size_t>(leaf.count);
    for (unsigned left = may_cross(leaf, start - origin_, end - origin_, scale); left != 0; left &= left - 1) {
      const int triangle = leaf.triangle[static_cast<std::size_t>(std::countr_zero(left))];
      const std::optional<double> fraction = front_crossing(start, end, corners(static_cast<std::size_t>(triangle)));
      if (fraction) take_if_first(*surface_, {triangle, *fraction}, first, until);
    }
  });
  return first;
}

namespace {

/// The vector from the closest point of a triangle to `place`. On a face it is exactly along the normal, however short.
struct FromTriangle {
  Vec3d line;  // as long as the distance
  double distance;
};

FromTriangle from_triangle(const Vec3d& place, const Corners& t) {
  const PointOnTriangle on = closest_on_triangle(place, t);
  if (on.feature != Feature::face) {
    const Vec3d line = place - on.point;
    return {line, norm(line)};
  }
  const Vec3d normal = normalised(cross(t.b - t.a, t.c - t.a));
  const double height = dot(place - t.a, normal);
  return {height * normal, std::fabs(height)};
}

// The distance from a triangle is a convex function along a straight path. So Newton's method from a point with a larger distance never
// overshoots the solution, and once the distance stops decreasing it never decreases again. For a face, one step suffices.
std::optional<double> time_of_contact(const Vec3d& start, const Vec3d& displacement, const Corners& corners, double radius, double tolerance, double until) {
  constexpr int max_steps = 100;   // at grazing contact each step halves the remainder
  constexpr double along = 1e-14;  // a slope within rounding: a path along the triangle, not towards it
  double fraction = 0;
  for (int step = 0; step < max_steps; ++step) {
    const FromTriangle from = from_triangle(start + fraction * displacement, corners);
    const double fall = -dot(from.line, displacement), gap = from.distance - radius;  // over the whole path the distance falls by fall/distance
    if (gap <= tolerance && (fraction > 0 || fall > along * from.distance * norm(displacement) || from.distance == 0)) return fraction;
    if (gap <= tolerance || !(fall > 0)) return std::nullopt;
    const double next = fraction + gap * from.distance / fall;
    if (!(next <= until)) return std::nullopt;
    if (next == fraction) return fraction;
    fraction = next;
  }
  return fraction;
}

}  // namespace

std::optional<Crossing> Bvh::first_contact(const Vec3d& start, const Vec3d& end, double radius, double tolerance, int guess, const Nearby& nearby,
                                           std::size_t& tested) const {
  std::optional<Crossing> first;
  if (!is_finite(start) || !is_finite(end)) return first;
  double until = 1;
  const double margin = radius + tolerance, scale = scale_of(start, end);
  const Vec3d way = end - start;
  const auto consider = [&](int triangle) {
    ++tested;
    const std::optional<double> fraction = time_of_contact(start, way, corners(static_cast<std::size_t>(triangle)), radius, tolerance, until);
    if (fraction) take_if_first(*surface_, {triangle, *fraction}, first, until);
  };
  if (guess >= 0) consider(guess);
  const double length = norm(way);
  visit_near_segment(start, end, until, margin, nearby, [&](const Leaf& leaf) {
    // The ball about the middle of the path until then contains all of it.
    const Vec3d middle = start - origin_ + 0.5 * until * way;
    for (unsigned left = may_be_within(leaf, middle, margin + 0.5 * until * length, scale); left != 0; left &= left - 1) {
      const int triangle = leaf.triangle[static_cast<std::size_t>(std::countr_zero(left))];
      if (triangle != guess) consider(triangle);
    }
  });
  return first;
}

std::optional<double> Bvh::distance_to_segment(const Vec3d& start, const Vec3d& end, double cap, const Nearby& nearby, std::size_t& tested) const {
  if (!is_finite(start) || !is_finite(end)) return std::nullopt;
  const double until = 1;
  double best = cap;
  bool found = false;
  const double scale = scale_of(start, end), half = 0.5 * norm(end - start);
  const Vec3d middle = 0.5 * (start + end) - origin_;
  visit_near_segment(start, end, until, best, nearby, [&](const Leaf& leaf) {
    for (unsigned left = may_be_within(leaf, middle, best + half, scale); left != 0; left &= left - 1) {
      ++tested;
      const int triangle = leaf.triangle[static_cast<std::size_t>(std::countr_zero(left))];
      const double distance = std::sqrt(squared_distance_of_segment(start, end, corners(static_cast<std::size_t>(triangle))));
      if (distance <= best) best = distance, found = true;
    }
  });
  if (!found) return std::nullopt;
  return best;
}

int Bvh::enclosures(const Vec3d& point, int solid) const {
  const RayCrossing ray(surface_->vertices(), surface_->triangles());
  const Vec3d end{std::max(point.x, surface_->report().bounds.high.x) + 1, point.y, point.z};
  const double until = 1, margin = 0;
  int sum = 0;
  visit_segment(point, end, until, margin, [&](const Leaf& leaf) {
    for (std::size_t l = 0; l < static_cast<std::size_t>(leaf.count); ++l) {
      const auto t = static_cast<std::size_t>(leaf.triangle[l]);
      if (surface_->solid_of(t) == solid) sum += ray(point, t);
    }
  });
  return sum;
}

}  // namespace fccda
