/// Distance and intersection queries for one triangle: closest point, crossing by a segment, distance to a segment.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/vec3.hpp"
#include "mesh/triangle.hpp"

namespace fccda {

/// A triangle by its corners.
struct Corners {
  Vec3d a, b, c;  ///< [m]
};

/// A point of a triangle.
struct PointOnTriangle {
  Vec3d point;      ///< [m]
  Feature feature;  ///< of the triangle
};

/// The point of a triangle that is closest to `point`. On an edge or vertex the feature is that edge or vertex, even if the foot of the
/// perpendicular lies exactly there.
inline PointOnTriangle closest_on_triangle(const Vec3d& point, const Corners& t) {
  const Vec3d from_a = point - t.a, from_b = point - t.b, from_c = point - t.c;
  const Vec3d ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
  const Vec3d normal = cross(ab, -ca);
  // Inside all three edges: the point is on the inner side of each edge's plane, which is perpendicular to the triangle.
  const double inside_ab = dot(cross(ab, from_a), normal), inside_bc = dot(cross(bc, from_b), normal), inside_ca = dot(cross(ca, from_c), normal);
  if (inside_ab > 0 && inside_bc > 0 && inside_ca > 0) return {point - (dot(from_a, normal) / squared_norm(normal)) * normal, Feature::face};

  const auto on_edge = [](const Vec3d& from, const Vec3d& edge, const Vec3d& start, const Vec3d& end, Feature first, Feature last, Feature along) {
    const double share = dot(from, edge) / squared_norm(edge);
    if (!(share > 0)) return PointOnTriangle{start, first};
    if (share >= 1) return PointOnTriangle{end, last};
    return PointOnTriangle{start + share * edge, along};
  };
  PointOnTriangle best = on_edge(from_a, ab, t.a, t.b, Feature::vertex_0, Feature::vertex_1, Feature::edge_0);
  for (const PointOnTriangle& other : {on_edge(from_b, bc, t.b, t.c, Feature::vertex_1, Feature::vertex_2, Feature::edge_1),
                                       on_edge(from_c, ca, t.c, t.a, Feature::vertex_2, Feature::vertex_0, Feature::edge_2)})
    if (squared_norm(point - other.point) < squared_norm(point - best.point)) best = other;
  return best;
}

/// Squared distance between two segments [m²].
inline double squared_distance_of_segments(const Vec3d& p, const Vec3d& p_end, const Vec3d& q, const Vec3d& q_end) {
  const Vec3d d = p_end - p, e = q_end - q, r = p - q;
  const double dd = squared_norm(d), ee = squared_norm(e), de = dot(d, e), dr = dot(d, r), er = dot(e, r);
  const double determinant = dd * ee - de * de;
  // The closest points of the two lines, then each clamped with the other one fixed: s on p, t on q.
  double s = determinant > 0 ? std::clamp((de * er - dr * ee) / determinant, 0.0, 1.0) : 0.0;
  double t = ee > 0 ? std::clamp((de * s + er) / ee, 0.0, 1.0) : 0.0;
  s = dd > 0 ? std::clamp((de * t - dr) / dd, 0.0, 1.0) : 0.0;
  t = ee > 0 ? std::clamp((de * s + er) / ee, 0.0, 1.0) : 0.0;
  return squared_norm(r + s * d - t * e);
}

/// Squared distance between a segment and a triangle that it does not cross [m²]: that of an end from the triangle or of the segment from
/// an edge.
inline double squared_distance_beside(const Vec3d& start, const Vec3d& end, const Corners& t) {
  double best = std::min(squared_norm(start - closest_on_triangle(start, t).point), squared_norm(end - closest_on_triangle(end, t).point));
  best = std::min(best, squared_distance_of_segments(start, end, t.a, t.b));
  best = std::min(best, squared_distance_of_segments(start, end, t.b, t.c));
  return std::min(best, squared_distance_of_segments(start, end, t.c, t.a));
}

/// The fraction along the segment from `start` (0) to `end` (1) at which it crosses the triangle from its front, the side that its normal
/// points to. A start on the plane counts as in front; an end on it has not crossed.
///
/// The three edge terms are computed so that the two triangles of an edge obtain exactly opposite values (products and their differences
/// round alike), so a path cannot pass between them. The tolerance covers vertices, where about 1 % of paths would be lost without it. It
/// is the rounding error of the terms and no more: a point relocated onto an edge lies 1e-12 off it, and leaves over it without crossing
/// the plane beyond.
///
/// For a path in the plane up to rounding, all three terms are noise, whatever its position. It crosses the triangle only if it is as close
/// to it as its ends are to the plane.
inline std::optional<double> front_crossing(const Vec3d& start, const Vec3d& end, const Corners& t) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon(), rounding = 16 * epsilon;
  const Vec3d normal = cross(t.b - t.a, t.c - t.a);
  const double before = dot(start - t.a, normal), after = dot(end - t.a, normal);
  if (!(before >= 0 && after < 0)) return std::nullopt;
  const Vec3d way = start - end, a = t.a - start, b = t.b - start, c = t.c - start;  // backwards, so that the terms are positive inside
  const double u = dot(way, cross(b, c)), v = dot(way, cross(c, a)), w = dot(way, cross(a, b));
  const double furthest = std::max({squared_norm(a), squared_norm(b), squared_norm(c)});
  const double least = -rounding * norm(way) * furthest;
  if (!(u >= least && v >= least && w >= least)) return std::nullopt;
  if (u < -least || v < -least || w < -least) {
    const double near = (before - after) / norm(normal) + 64 * epsilon * std::sqrt(std::max(furthest, squared_norm(way)));
    if (squared_distance_beside(start, end, t) > near * near) return std::nullopt;
  }
  return before / (before - after);
}

/// True if the segment crosses the triangle, from either side.
inline bool crosses(const Vec3d& start, const Vec3d& end, const Corners& t) {
  return front_crossing(start, end, t).has_value() || front_crossing(end, start, t).has_value();
}

/// Squared distance between a segment and a triangle [m²]: 0 if they intersect.
inline double squared_distance_of_segment(const Vec3d& start, const Vec3d& end, const Corners& t) {
  return crosses(start, end, t) ? 0 : squared_distance_beside(start, end, t);
}

}  // namespace fccda
