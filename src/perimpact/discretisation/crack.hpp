/// A crack that is there from the start: a plane polygon. Bonds whose straight line between the particles' reference positions goes through it
/// are cut.
///
/// What is decided at the edges (docs/guide/solids.md):
///  - a bond that touches the polygon's edge or a corner is cut;
///  - a particle in the crack's plane counts as on the side that the polygon's normal points to (the corners run anticlockwise seen from there), so
///    a bond within the plane is never cut, and the crack still parts one side from the other.
/// On the edge, and in the plane, means up to `tolerance`.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

class Crack {
 public:
  /// `polygon` [m], at least three corners. Throws InputError, one sentence, where they are fewer, not in one plane within a thousandth of the
  /// polygon's size, without area, or where sides cross or touch one another.
  Crack(const std::vector<Vec3d>& polygon, double tolerance);

  /// A crack of a plane body, from `a` to `b`, through all of its thickness. Throws InputError where these are one point.
  static Crack through_thickness(const Vec3d& a, const Vec3d& b, double tolerance);

  bool cuts(const Vec3d& one, const Vec3d& other) const;

  /// False where no bond of length `reach` [m] from here can be cut.
  bool may_reach(const Vec3d& point, double reach) const { return std::fabs(height(point)) <= reach + tolerance_; }

  /// A particle in the polygon, or on its edge.
  bool holds(const Vec3d& point) const { return std::fabs(height(point)) <= tolerance_ && is_in_polygon(point); }

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
