/// Contact of one point with the surface over one step, in the body frame (continuous collision detection).
///
/// A point is a ball of the contact radius r >= 0. Its path is the straight line between its positions at the two ends of the step. If the
/// rotation of the body is large, it is a polyline (curved_path.hpp). The ends are exact and consecutive paths join, so nothing passes
/// undetected. The ball is in contact if the path comes nearer to the surface than r, or crosses it from the front. It is relocated
///   - to the distance r from the surface's point closest to the end of the path, among the triangles that face its start (which excludes
///     the far side of a thin blade),
///   - or, if the path ends outside again, past an edge or right through a blade, to its end, less the displacement against the normal
///     after first contact,
///   - in concave regions, to the nearest position at the distance r from everything,
///   - if there is none, or the straight line to it is obstructed, to the same about its position of first contact,
///   - and as a last resort to its start.
/// There, an offset of max(1e-12 size, 32 ε max|coordinate|) is added to r, and it is subtracted in the contact test: rest at the surface,
/// and motion away from it, is not contact.
///
/// Sides: a closed surface has an inside, by the pseudonormal of the closest feature (Bærentzen and Aanæs 2005), and where parts overlap,
/// that of their union (search/solids.hpp). An open surface has a front, and contact is from there only. Beyond its boundary no side is
/// defined, so only crossing counts; the side of a ball is evaluated at its first contact.
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
#include "fccda/detect/relocator.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/search/indexed_surface.hpp"

namespace fccda {

/// The path of one point in one step.
struct PathQuery {
  CurvedPath path;          ///< of the point, in the body frame
  double radius = 0;        ///< [m] of contact
  double offset = 0;        ///< [m]
  double look_ahead = 0;    ///< [m] beyond the contact radius, up to which a distance is worth determining
  bool entered = false;     ///< the point is known to have entered where contact is ignored
  bool in_contact = false;  ///< it was in contact in the previous step: if it starts inside, it was pushed there (for open surfaces only)
  bool renumbered = false;  ///< neither is known; it is regarded as entered if it starts inside by more than its path length
};

/// What the surface means for one point in one step.
struct PathResult {
  std::optional<BodyFrameContact> contact{};  ///< the contact, if there is one
  double clearance = 0;                       ///< [m] lower bound of the distance beyond the contact radius, at the end of the path
  bool enters = false;                        ///< entered where contact is ignored: no contact before it is outside again
  bool leaves = false;                        ///< was such a point, and is outside again
  bool is_first_entry = true;                 ///< enters for the first time, as far as is known
  bool in_contact_as_ball = false;            ///< in contact as a whole ball, not with its centre only
};

/// Contact of single paths with a surface; many threads may use one object.
class PathTest : private Relocator {
 public:
  using Relocator::Nearest;

  /// `radius` [m]: contact radius of points without an individual one.
  PathTest(SharedSurface surface, ContactBounds region, double radius);
  /// With search structures of its own.
  PathTest(std::shared_ptr<const Surface> surface, ContactBounds region, double radius) : PathTest(share(std::move(surface)), std::move(region), radius) {}

  /// `guess`: a triangle expected to be near, or -1; updated.
  PathResult evaluate(const PathQuery& query, int& guess, Effort& effort) const;

  /// True inside the surface, or nearer to it than the contact radius by more than `tolerance` [m]; for an open surface, in front of it.
  bool is_inside(const Vec3d& point, double tolerance) const { return is_inside(point, tolerance, radius_); }
  /// The same for a point with its own contact radius [m].
  bool is_inside(const Vec3d& point, double tolerance, double radius) const;

  using Relocator::nearest;
  using Relocator::slide;
  using Relocator::solids;
  using Relocator::surface;
  double radius() const { return radius_; }  ///< [m]
  double size() const { return size_; }      ///< [m] the largest extent of the surface

 private:
  /// The first straight part of the path that leads to contact.
  struct Leg {
    Path path;
    ClosestPoint at_start;
    double begin, share;  // of the step: when it begins, how much of it it is
  };

  bool leads_to_contact(const Path& path, const ClosestPoint& at_start, const ClosestPoint& at_end, const Ball& ball, const Bvh::Nearby& nearby,
                        std::size_t& tested) const;
  std::optional<Leg> first_leg(const CurvedPath& path, const Vec3d& start, const ClosestPoint& at_start, const ClosestPoint& at_end, const Ball& ball,
                               const Bvh::Nearby& nearby, std::size_t& tested) const;
  BodyFrameContact first_contact(const Leg& leg, const Ball& ball, const Bvh::Nearby& nearby, std::size_t& tested) const;

  SharedSurface shared_;  // owner of what the base refers to
  ContactBounds region_;
  double radius_;
  double size_;
};

/// The points that are inside at t0 of the coming step. Contact alone is not inside: the tolerance of 1e-9 of the surface's size is far above
/// the rounding of coordinates and far below a relevant penetration.
template <Points P>
std::vector<std::size_t> initial_overlap(const PathTest& test, const P& points, const Pose& pose) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.occupied(i) && test.is_inside(pose.to_body(points.position_t0(i)), 1e-9 * test.size(), contact_radius(points, i, test.radius())))
      inside.push_back(i);
  return inside;
}

/// Those of the points that are inside at t1, with the same tolerance, except those for which `is_excused`.
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
