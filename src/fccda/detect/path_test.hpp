/// The geometry of one point against the surface over one step, in the frame of the body.
///
/// A point is a ball of the contact radius r >= 0. Its path is the straight line between its places at the two ends of the step or, where
/// the body turns by much, a polyline (bent_path.hpp); the ends are exact and consecutive paths join, so nothing gets through unseen. The
/// ball touches where the path comes nearer to the surface than r, or crosses it from the front. It is put back
///   - at the distance r from the surface's point that is closest to the end of the path, among the triangles that face its start
///     (the far side of a thin blade does not),
///   - or, where the path ends outside again, past an edge or right through a blade, there, less what it went against the normal after
///     first touch,
///   - in concave places, at the place nearest to that which is r away from everything,
///   - if there is none, or the straight way to it is not clear, the same about where it was first touched,
///   - and at last where it began.
/// An offset of max(1e-12 size, 32 ε max|coordinate|) is added to r there, and taken off where contact is asked for: rest at the
/// surface, and motion away from it, is no contact.
///
/// Sides: a closed surface has an inside, by the pseudonormal of the closest feature (Bærentzen and Aanæs 2005), and where parts of it
/// overlap that of their union (search/solids.hpp). An open one has a front; contact comes from there only, and beyond its rim no side is known, so only
/// crossing counts; a ball is asked where it first touches.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/curved_path.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/search/indexed_surface.hpp"

namespace fccda {

/// A contact in the frame of the body.
struct Touch {
  double time_fraction;
  Vec3d hit;          ///< [m] of the surface, where it is first touched
  Vec3d normal;       ///< unit, out of the surface, at the place of relocation
  Vec3d relocation;   ///< [m]
  int triangle;       ///< of the relocation
  Vec3d normal_t0{};  ///< unit, out of the surface, where the ball began in contact; 0 where it did not, or ran into another part of the surface
  bool front = true;  ///< it was in front of what it touched first; not so beside the rim of an open surface, and behind it
};

struct PathQuestion {
  CurvedPath path;
  double radius = 0;        ///< [m] of contact
  double offset = 0;        ///< [m]
  double look_ahead = 0;    ///< [m] how far beyond the reach of contact a distance is worth knowing
  bool entered = false;     ///< the point is known to have come in where the surface is not felt
  bool touched = false;     ///< it was in contact a step ago: should it start inside, it was pushed there (asked of open surfaces only)
  bool renumbered = false;  ///< neither is known, and it may have come in before: it has, where it starts inside by more than its way
};

struct PathAnswer {
  std::optional<Touch> touch{};
  double clearance = 0;  ///< [m] the surface is at least this much further than contact reaches, at the end of the path
  bool enters = false;   ///< came in where the surface is not felt: not struck before it is outside again
  bool leaves = false;   ///< was such a point, and is outside again
  bool anew = true;      ///< as far as is known it enters for the first time
  bool held = false;     ///< touched with the whole ball, not with its centre only
};

class PathTest {
 public:
  /// What a point must keep away from: the closest point of the surface or, among solids that overlap, of the one it is deepest in.
  struct Nearest {
    ClosestPoint closest;
    double distance;  ///< [m] negative inside a closed surface
  };

  /// `radius` [m]: of contact, of points that have none of their own.
  PathTest(SharedSurface surface, ContactBounds region, double radius);
  PathTest(std::shared_ptr<const Surface> surface, ContactBounds region, double radius) : PathTest(share(std::move(surface)), std::move(region), radius) {}

  /// `guess`: a triangle thought to be near, or -1; updated.
  PathAnswer ask(const PathQuestion& question, int& guess, Effort& effort) const;

  /// Inside the surface, or nearer to it than the contact radius by more than `tolerance` [m]; in front of it where it is open.
  bool is_inside(const Vec3d& point, double tolerance) const { return is_inside(point, tolerance, radius_); }
  bool is_inside(const Vec3d& point, double tolerance, double radius) const;

  /// `guess`: a triangle thought to be near, or -1. Nothing for a point that is no number.
  std::optional<Nearest> nearest(const Vec3d& point, int guess, std::size_t& asked) const { return nearest(point, {}, guess, asked); }

  /// Where a point at `from` gets to on its way to `to`, as SlidingSurface says, in the frame of the body. `offset` as it was asked with.
  Vec3d slide(const Vec3d& from, const Vec3d& to, double radius, double offset) const;

  const Surface& surface() const { return *surface_; }
  const Solids& solids() const { return *solids_; }
  double radius() const { return radius_; }  ///< [m]
  double size() const { return size_; }      ///< [m] the largest extent of the surface

 private:
  /// What counts as touching in this question.
  struct Ball {
    double radius;  // [m]
    double offset;  // [m]
  };

  /// The first straight part of the path that leads to contact.
  struct Leg {
    Path path;
    ClosestPoint at_start;
    double begin, share;  // of the step: when it begins, how much of it it is
  };

  /// A place outside, and what is nearest there.
  struct Place {
    Vec3d point;      // [m]
    Vec3d direction;  // unit, out of the surface
    int triangle;
  };

  /// What a search for a place outside begins with.
  struct Around {
    const Bvh::Nearby& nearby;
    Vec3d start;   // [m] of the path
    Vec3d viewer;  // [m] the start, off the surface
    Ball ball;
  };

  ClosestPoint closest_on(int triangle, const Vec3d& point) const;
  int side(const ClosestPoint& closest, const Vec3d& point, std::size_t& asked) const;
  Vec3d outward(const ClosestPoint& closest, const Vec3d& point, double tiny) const;
  bool too_near(const ClosestPoint& closest, const Vec3d& point, double distance, std::size_t& asked) const;
  std::optional<ClosestPoint> closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, const ClosestPoint& closest, std::size_t& asked) const;
  std::optional<Nearest> nearest(const Vec3d& point, const Bvh::Nearby& nearby, int guess, std::size_t& asked) const;
  bool leads_to_contact(const Path& path, const ClosestPoint& at_start, const ClosestPoint& at_end, const Ball& ball, std::size_t& asked) const;
  std::optional<Leg> first_leg(const CurvedPath& path, const Vec3d& start, const ClosestPoint& at_start, const ClosestPoint& at_end, const Ball& ball,
                               std::size_t& asked) const;
  Touch first_touch(const Leg& leg, const Ball& ball, std::size_t& asked) const;
  std::optional<Place> first_place(const Touch& touch, const Vec3d& end, const ClosestPoint& at_end, const Around& around, std::size_t& asked) const;
  std::optional<Place> clear_place(Place place, const Vec3d& wanted, const Around& around, std::size_t& asked) const;
  Vec3d normal_at_start(const Leg& leg, const Touch& touch, const Path& path, const Ball& ball) const;
  void relocate(Touch& touch, const Vec3d& end, const ClosestPoint& at_end, const Around& around, std::size_t& asked) const;

  SharedSurface shared_;  // owner of the next three
  const Surface* surface_;
  const Bvh* bvh_;
  const Solids* solids_;
  ContactBounds region_;
  double radius_;
  double size_;
};

/// The points that are inside at t0 of the coming step. Touching is not inside: 1e-9 of the surface's size is allowed for, far more than
/// the rounding of coordinates and far less than what contact would show.
template <Points P>
std::vector<std::size_t> initial_overlap(const PathTest& test, const P& points, const Pose& pose) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.occupied(i) && test.is_inside(pose.to_body(points.position_t0(i)), 1e-9 * test.size(), contact_radius(points, i, test.radius())))
      inside.push_back(i);
  return inside;
}

/// Those of the points that are inside at t1, by as much, less those that `is_excused`.
template <Points P, class IsExcused>
std::vector<std::size_t> still_inside(const PathTest& test, const P& points, const Pose& pose, std::span<const std::size_t> which,
                                      const IsExcused& is_excused) {
  std::vector<std::size_t> inside;
  for (const std::size_t i : which)
    if (test.is_inside(pose.to_body(points.position_t1(i)), 1e-9 * test.size(), contact_radius(points, i, test.radius())) && !is_excused(i))
      inside.push_back(i);
  return inside;
}

}  // namespace fccda
