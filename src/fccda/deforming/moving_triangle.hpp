/// Contact of a point or ball with one moving triangle, within a step in which the point and the three corners move straight and uniformly
/// (continuous collision detection). No contact is missed, and none is found beyond rounding.
///
/// Crossing. The volume of point and triangle, s(t) = (p-a)·((b-a)×(c-a)), is a cubic in time, and its sign is the side of the triangle's plane. With
/// the differences d, e, f of the corners from p and of the edges, in the maximum norm, and u = 2⁻⁵³,
///   |computed s(t) - s(t)| <= E = 256 u d e f
/// The volume is certainly positive above E and certainly negative below -E. Between the three parts of the step that the extrema of s bound,
/// it is monotone. The point crosses the plane from the front between the last certainly positive and the first certainly negative time;
/// a start that is not certainly behind counts as in front. In this interval, of length h, the exact crossing takes place, so that
/// at its middle the point is no farther from the triangle than δ = 64 u (|p-a| + …) + V h/2, V being the largest speed relative to a corner.
/// If it is, nothing has been crossed; else the interval is halved until the second term no longer matters.
///
/// Every triangle decides alone, and every decision errs on the side of contact. So a path through an edge or vertex crosses at least one of the
/// triangles there, whatever the rounding. A path is found to cross a triangle that it misses only if it passes within 1e-13 of the
/// size of the triangle and the path from its border.
///
/// Ball. The triangle is convex, so a plane between it and the ball bounds the distance from below while both move: of the plane at the closest point, with
/// the normal n, the corners have the distances h_i = n·(p - x_i), which change at constant rates. Until the first falls to the radius there is
/// no contact. Such steps never pass a contact, and converge quadratically (Newton's method where the closest point is a corner).
///
/// Brochu, Edwards and Bridson, ACM TOG 31 (2012) 96, and Wang, Ferguson, Schneider, Jiang, Attene and Panozzo, ACM TOG 40 (2021) 188, show why
/// the cubic must not be solved without bounds of its error.
#pragma once

#include <array>
#include <optional>

#include "fccda/contact_bounds/path.hpp"
#include "mesh/search/closest_point.hpp"

namespace fccda {

/// A triangle whose corners move straight from t0 to t1.
struct MovingTriangle {
  Corners t0, t1;  ///< [m] at the two ends of the step

  /// Its corners at a fraction of the step from 0 to 1; exact at both ends.
  Corners at(double fraction) const {
    const double left = 1 - fraction;
    return {left * t0.a + fraction * t1.a, left * t0.b + fraction * t1.b, left * t0.c + fraction * t1.c};
  }
};

/// The fraction of the step at which a point first crosses the triangle from its front, the side that its normal points to. A start on the
/// plane counts as in front; an end on it has not crossed.
std::optional<double> front_crossing(const Path& point, const MovingTriangle& triangle);

/// The fraction of the step, at most `until`, at which a ball of `radius` > 0 [m] first comes within `tolerance` > 0 [m] of contact with the
/// triangle. A ball in contact at the start counts only if it moves farther in.
std::optional<double> first_contact(const Path& centre, const MovingTriangle& triangle, double radius, double tolerance, double until);

/// Barycentric coordinates of the triangle's point closest to `point`: at least 0, of sum 1.
std::array<double, 3> barycentric(const Corners& triangle, const Vec3d& point);

}  // namespace fccda
