/// Bounding volume hierarchy (BVH) over the triangles of a surface, for closest-point queries and path intersection.
///
/// Four boxes per node, leaves of four triangles. Boxes are floats, rounded outward by enough to cover every rounding error of a query. So a
/// query returns exactly the minimum over all triangles, whatever the order of the search: a guess changes the cost, never the answer. Ties
/// go to the lowest panel, then the lowest triangle. Queries with not-a-number return nothing.
///
/// Only refit() changes it after construction, so any number of threads may query it concurrently.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/aligned.hpp"
#include "mesh/search/closest_point.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Result of a closest-point query.
struct ClosestPoint {
  int triangle;     ///< number of the triangle
  Feature feature;  ///< of the triangle
  Vec3d point;      ///< [m] of the surface
  double distance;  ///< [m]
};

/// Where a path crosses a surface.
struct Crossing {
  int triangle;     ///< number of the triangle
  double fraction;  ///< of the path from start to end
};

/// Keeps the earlier of two crossings, and its fraction as `until`. Of those at the same fraction the panel with the smallest number comes
/// first, then the triangle, whatever the order in which they are found.
void take_if_first(const Surface& surface, const Crossing& found, std::optional<Crossing>& first, double& until);

/// Bounding volume hierarchy over triangles.
class Bvh {
 public:
  static constexpr double no_cap = std::numeric_limits<double>::infinity();  ///< [m] search without limit

  /// Cached surroundings of a search: further searches nearby need no traversal of the tree. The results are the same.
  struct Nearby {
    Vec3d centre{};                         ///< [m] of the first search
    double distance = 0;                    ///< [m] of the surface from the centre
    double reach = 0;                       ///< [m] radius about the centre in which the cache is valid
    std::size_t count = 0;                  ///< number of leaves
    std::array<std::int32_t, 16> leaves{};  ///< leaves that may contain the closest point for any point within reach

    /// Adds a leaf; a full cache becomes invalid.
    void add(std::int32_t leaf) {
      if (count == leaves.size()) reach = 0;  // too many for the cache to pay off
      if (reach > 0) leaves[count++] = leaf;
    }

    /// Whether it has every leaf with a triangle at most `furthest` [m] from the centre. A hundredth of the reach is reserved for rounding.
    bool covers(double furthest) const { return reach > 0 && furthest < distance + 1.98 * reach; }
  };

  /// `surface` must outlive the object.
  explicit Bvh(const Surface& surface);

  /// Over a subset of the triangles, in ascending order. Guesses are ignored.
  Bvh(const Surface& surface, std::span<const std::int32_t> triangles);

  /// The same tree over another surface with the same triangles, whose vertices are elsewhere.
  Bvh(const Bvh& tree, const Surface& surface);

  /// Follows a surface whose vertices have moved. The tree keeps its shape, and queries remain exact, but slow down as triangles that are
  /// together in the tree move apart: see cost().
  void refit();

  /// Expected number of boxes that a query meets: the sum of their surface areas over that of the whole (the surface area heuristic).
  double cost() const;

  /// The closest point of the surface within `cap` [m]. `guess` is a triangle expected to be near, or -1. `tested` counts the triangles
  /// evaluated.
  std::optional<ClosestPoint> closest(const Vec3d& point, double cap, int guess, std::size_t& tested) const;
  /// The same without guess.
  std::optional<ClosestPoint> closest(const Vec3d& point, double cap = no_cap) const;

  /// The same, and collects the surroundings for queries at other points within `reach` [m] of this one, if so few triangles are there that it pays off.
  std::optional<ClosestPoint> closest(const Vec3d& point, double cap, int guess, double reach, Nearby& nearby, std::size_t& tested) const;

  /// The closest point of the surface, found with the cached surroundings.
  std::optional<ClosestPoint> closest(const Vec3d& point, const Nearby& nearby, int guess, std::size_t& tested) const;

  /// The same before a motion, with surroundings of the centre after it, in a tree of the same shape: `point` was no farther than `way` [m] from the centre, as
  /// seen from any point of the surface.
  std::optional<ClosestPoint> closest_before(const Vec3d& point, const Nearby& nearby, double way, int guess, std::size_t& tested) const;

  /// The closest point within `cap` [m] among the triangles whose front faces `viewer`.
  std::optional<ClosestPoint> closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, std::size_t& tested) const;

  /// The first triangle that the segment crosses from its front.
  std::optional<Crossing> first_hit(const Vec3d& start, const Vec3d& end, std::size_t& tested) const { return first_hit(start, end, {}, tested); }
  /// The same with cached surroundings.
  std::optional<Crossing> first_hit(const Vec3d& start, const Vec3d& end, const Nearby& nearby, std::size_t& tested) const;

  /// First contact of a ball of `radius` [m] whose centre moves along the segment: the triangle and the fraction, at most `tolerance` [m]
  /// early. A triangle in contact at the start counts only if the ball moves towards it. `guess`: a triangle expected to be met, or -1.
  std::optional<Crossing> first_contact(const Vec3d& start, const Vec3d& end, double radius, double tolerance, int guess, std::size_t& tested) const {
    return first_contact(start, end, radius, tolerance, guess, {}, tested);
  }
  /// The same with cached surroundings.
  std::optional<Crossing> first_contact(const Vec3d& start, const Vec3d& end, double radius, double tolerance, int guess, const Nearby& nearby,
                                        std::size_t& tested) const;

  /// Distance between the segment and the surface if it is at most `cap` [m].
  std::optional<double> distance_to_segment(const Vec3d& start, const Vec3d& end, double cap, std::size_t& tested) const {
    return distance_to_segment(start, end, cap, {}, tested);
  }
  /// The same with cached surroundings.
  std::optional<double> distance_to_segment(const Vec3d& start, const Vec3d& end, double cap, const Nearby& nearby, std::size_t& tested) const;

  /// Winding number of the triangles of one solid about the point: the sum over the crossings of a ray along x (ray_crossing.hpp).
  int enclosures(const Vec3d& point, int solid) const;

  /// Calls visit(triangle) for all triangles of leaves whose box intersects this one, and possibly for some nearby.
  template <class Visit>
  void visit_box(const Box& box, const Visit& visit) const;

  /// A ball whose centre moves straight, beside a surface whose vertices do.
  struct MovingBall {
    Vec3d start, end;  ///< [m] of the centre
    double radius;     ///< [m]
    double way;        ///< [m] bound of how far the centre moves relative to any point of the surface
  };

  /// Calls visit(triangle) for all triangles that the ball meets in the first `until` of a step, and possibly for some nearby, about in the order in
  /// which it meets them. Each vertex moves straight from its place in `at_t0`, a tree of the same shape, to its place in this one. So a vertex is
  /// always between the bounds of its boxes at the two ends, interpolated in time, which follow a surface that moves as a whole more closely than a
  /// box about both ends. `until` may shrink meanwhile. `nearby`: surroundings of the end of the ball's path, in this tree.
  template <class Visit>
  void visit_moving(const Bvh& at_t0, const MovingBall& ball, const Nearby& nearby, const double& until, const Visit& visit) const;

 private:
  static constexpr std::size_t width = 4;
  // Three siblings wait at each level, and there are at most 116 levels (bvh_build.cpp).
  static constexpr std::size_t stack_size = 512;

  /// Boxes of the children by coordinate, relative to origin_; an absent child has low > high.
  struct alignas(64) Node {
    std::array<std::array<float, width>, 3> low, high;
    std::array<std::int32_t, width> child;  ///< a node, or ~leaf
  };

  /// Four triangles by coordinate; a leaf of fewer repeats the last one, without a number of its own.
  struct Leaf {
    std::array<std::array<double, width>, 3> a, ab, ac;
    std::array<double, width> inverse_ab, inverse_bc, inverse_ca, inverse_normal;  ///< 1/|edge|² and 1/|ab × ac|²
    std::array<std::int32_t, width> triangle;
    std::int32_t count;
  };

  class Builder;

  class Closest;

  template <class Accept>
  std::optional<ClosestPoint> search_closest(const Vec3d& point, double cap, int guess, std::size_t& tested, Nearby* nearby, const Accept& accept) const;
  std::optional<ClosestPoint> closest_of(const Vec3d& point, const Nearby& nearby, std::size_t& tested) const;
  template <class Visit>
  void visit_segment(const Vec3d& start, const Vec3d& end, const double& until, const double& margin, const Visit& visit) const;
  template <class Visit>
  void visit_near_segment(const Vec3d& start, const Vec3d& end, const double& until, const double& margin, const Nearby& nearby, const Visit& visit) const;
  void fill(Leaf& leaf) const;
  template <class Corner>
  static void set_corners(Leaf& leaf, const Vec3d& origin, const Corner& corner);
  const Leaf& current_leaf(std::int32_t index, Leaf& room) const;
  void list_leaf_vertices();
  static void set_box(Node& node, std::size_t child, const Box& box, double slack);
  static std::array<double, width> squared_distances(const Leaf& leaf, const Vec3d& point);
  static unsigned may_cross(const Leaf& leaf, const Vec3d& from, const Vec3d& to, double scale);
  static unsigned may_be_within(const Leaf& leaf, const Vec3d& point, double distance, double scale);
  double scale_of(const Vec3d& start, const Vec3d& end) const;

  /// A node or leaf to visit, and the fraction of a path at which its box is entered.
  struct Pending {
    double enter;
    std::int32_t child;
  };

  // Adds the children with the given bits to the stack, the last first, so that the first is popped next.
  static void push(std::array<Pending, stack_size>& stack, std::size_t& depth, const std::array<double, width>& enter, unsigned children, const Node& node) {
    const std::size_t base = depth;
    for (; children != 0; children &= children - 1) {
      const auto c = static_cast<std::size_t>(std::countr_zero(children));
      std::size_t at = depth++;
      for (; at > base && stack[at - 1].enter < enter[c]; --at) stack[at] = stack[at - 1];
      stack[at] = {enter[c], node.child[c]};
    }
  }

  unsigned may_meet(const Bvh& at_t0, std::int32_t leaf, const MovingBall& ball, double until) const;

  Corners corners(std::size_t triangle) const { return {surface_->corner(triangle, 0), surface_->corner(triangle, 1), surface_->corner(triangle, 2)}; }

  const Surface* surface_;
  Vec3d origin_;       // centre of the surface, where floats are finest
  double worthwhile_;  // [m] reach of a cache of surroundings that costs less than it saves: 0.3 of the mean size of a triangle
  AlignedVector<Node> nodes_;
  AlignedVector<Leaf> leaves_;
  // Once refitted, the coordinates of the leaves are outdated; the vertices of their triangles stand here, in the order of the leaves.
  std::vector<std::array<std::int32_t, 3 * width>> leaf_vertices_;
  std::vector<std::int32_t> leaf_of_;  // by triangle; empty for a subset of the triangles
};

// corner(3 l + c): corner c of the l-th triangle [m].
template <class Corner>
void Bvh::set_corners(Leaf& leaf, const Vec3d& origin, const Corner& corner) {
  for (std::size_t l = 0; l < width; ++l) {
    const Vec3d at = corner(3 * l), a = at - origin, ab = corner(3 * l + 1) - at, ac = corner(3 * l + 2) - at;
    for (std::size_t axis = 0; axis < 3; ++axis) leaf.a[axis][l] = a[axis], leaf.ab[axis][l] = ab[axis], leaf.ac[axis][l] = ac[axis];
  }
  // Of an edge or area without extent 0: the closest point is then on another feature.
  const auto inverse = [](double square) { return square > 0 ? 1 / square : 0; };
#pragma omp simd
  for (std::size_t l = 0; l < width; ++l) {
    const Vec3d ab{leaf.ab[0][l], leaf.ab[1][l], leaf.ab[2][l]}, ac{leaf.ac[0][l], leaf.ac[1][l], leaf.ac[2][l]};
    leaf.inverse_ab[l] = inverse(squared_norm(ab));
    leaf.inverse_bc[l] = inverse(squared_norm(ac - ab));
    leaf.inverse_ca[l] = inverse(squared_norm(ac));
    leaf.inverse_normal[l] = inverse(squared_norm(cross(ab, ac)));
  }
}

template <class Visit>
void Bvh::visit_box(const Box& box, const Visit& visit) const {
  std::array<std::array<float, 3>, 2> reach;  // rounding is covered by the slack of the tree's own boxes
  for (std::size_t axis = 0; axis < 3; ++axis)
    reach[0][axis] = static_cast<float>(box.low[axis] - origin_[axis]), reach[1][axis] = static_cast<float>(box.high[axis] - origin_[axis]);
  std::array<std::int32_t, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::int32_t next = stack[--depth];
    if (next < 0) {
      const Leaf& leaf = leaves_[static_cast<std::size_t>(~next)];
      for (std::size_t l = 0; l < static_cast<std::size_t>(leaf.count); ++l) visit(leaf.triangle[l]);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(next)];
    std::array<bool, width> meets;
#pragma omp simd
    for (std::size_t c = 0; c < width; ++c) {
      bool in = true;
      for (std::size_t axis = 0; axis < 3; ++axis) in &= node.low[axis][c] <= reach[1][axis] && node.high[axis][c] >= reach[0][axis];
      meets[c] = in;
    }
    for (std::size_t c = 0; c < width; ++c)
      if (meets[c] && node.low[0][c] <= node.high[0][c]) stack[depth++] = node.child[c];
  }
}

template <class Visit>
void Bvh::visit_moving(const Bvh& at_t0, const MovingBall& ball, const Nearby& nearby, const double& until, const Visit& visit) const {
  const auto visit_leaf = [&](std::int32_t index) {
    const Leaf& leaf = leaves_[static_cast<std::size_t>(index)];
    for (unsigned left = may_meet(at_t0, index, ball, until); left != 0; left &= left - 1)
      visit(leaf.triangle[static_cast<std::size_t>(std::countr_zero(left))]);
  };
  // A triangle that the ball meets is at t1 no farther from its centre than its radius and the way that is left.
  if (nearby.covers(norm(ball.end - nearby.centre) + ball.radius + ball.way)) {
    for (std::size_t k = 0; k < nearby.count; ++k) visit_leaf(nearby.leaves[k]);
    return;
  }
  const Vec3d p = ball.start - at_t0.origin_, q = ball.end - origin_;
  const double margin = ball.radius;
  std::array<Pending, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Pending next = stack[--depth];
    if (next.enter > until) continue;
    if (next.child < 0) {
      visit_leaf(~next.child);
      continue;
    }
    const Node &a = at_t0.nodes_[static_cast<std::size_t>(next.child)], &b = nodes_[static_cast<std::size_t>(next.child)];
    std::array<double, width> enter;
    unsigned meets = 0;
#pragma omp simd reduction(| : meets)
    for (std::size_t c = 0; c < width; ++c) {
      double first = 0, last = until;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // How far inside its two bounds the point is at the ends of the step: linear in between.
        const double low_t0 = p[axis] - static_cast<double>(a.low[axis][c]) + margin, low_t1 = q[axis] - static_cast<double>(b.low[axis][c]) + margin;
        const double high_t0 = static_cast<double>(a.high[axis][c]) - p[axis] + margin, high_t1 = static_cast<double>(b.high[axis][c]) - q[axis] + margin;
        const double low_at = low_t0 / (low_t0 - low_t1), high_at = high_t0 / (high_t0 - high_t1);
        const double low_enter = low_t0 < 0 ? (low_t1 < 0 ? 2 : low_at) : 0, low_leave = low_t1 < 0 ? (low_t0 < 0 ? -1 : low_at) : 1;
        const double high_enter = high_t0 < 0 ? (high_t1 < 0 ? 2 : high_at) : 0, high_leave = high_t1 < 0 ? (high_t0 < 0 ? -1 : high_at) : 1;
        first = first > low_enter ? first : low_enter;
        first = first > high_enter ? first : high_enter;
        last = last < low_leave ? last : low_leave;
        last = last < high_leave ? last : high_leave;
      }
      enter[c] = first;
      meets |= (first <= last && b.low[0][c] <= b.high[0][c] ? 1u : 0u) << c;
    }
    push(stack, depth, enter, meets, b);
  }
}

}  // namespace fccda
