/// Initial crack: a plane polygon. Bonds whose reference line segment intersects it are cut.
///
/// Limit cases (docs/guide/solids.md), each within `tolerance`:
///  - a bond that meets an edge or corner of the polygon is cut;
///  - a particle in the crack plane counts as on the side of the polygon's normal (corners anticlockwise seen from there), so that a bond
///    within the plane is never cut, and the crack still separates the two sides.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

class Crack {
 public:
  /// `polygon` [m], at least three corners. Throws InputError, one sentence, if there are fewer, if they are not coplanar within a thousandth
  /// of the polygon's size, or if the polygon has no area or intersects itself.
  Crack(const std::vector<Vec3d>& polygon, double tolerance);

  /// Through-thickness crack of a plane body from `a` to `b`. Throws InputError if these coincide.
  static Crack through_thickness(const Vec3d& a, const Vec3d& b, double tolerance);

  bool cuts(const Vec3d& one, const Vec3d& other) const;

  /// False if no bond of length `reach` [m] from this point can be cut.
  bool may_reach(const Vec3d& point, double reach) const { return std::fabs(height(point)) <= reach + tolerance_; }

  /// True for a point in the polygon or on its edge.
  bool contains(const Vec3d& point) const { return std::fabs(height(point)) <= tolerance_ && is_in_polygon(point); }

 private:
  using Point = std::array<double, 2>;  // in the crack's plane
  double height(const Vec3d& point) const { return dot(point - origin_, axes_[2]); }
  Point in_plane(const Vec3d& point) const { return {dot(point - origin_, axes_[0]), dot(point - origin_, axes_[1])}; }
  bool is_in_polygon(const Vec3d& point) const;
  void expect_simple() const;

  double tolerance_;
  Vec3d origin_{};
  std::array<Vec3d, 3> axes_{};  // two in the plane, and the normal
  std::vector<Point> corners_;
};

}  // namespace perimpact
