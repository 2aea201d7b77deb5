/// Sides of a surface, and positions outside of it: the geometry of relocation (path_test.hpp), for a surface at one moment.
#pragma once

#include <optional>

#include "base/vec3.hpp"
#include "fccda/contact_bounds/path.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/search/solids.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// A contact in the body frame.
struct BodyFrameContact {
  double time_fraction;  ///< 0 at t0 to 1 at t1
  Vec3d hit;             ///< [m] point of the surface first in contact
  Vec3d normal;          ///< unit, out of the surface, at the relocated position
  Vec3d relocation;      ///< [m]
  int triangle;          ///< of the relocation
  Vec3d normal_t0{};     ///< unit, out of the surface, where the ball was in contact at t0; 0 if it was not, or entered another part of the surface
  bool front = true;     ///< it was in front of the first triangle in contact; false beside the boundary of an open surface, and behind it
};

/// Positions relative to a surface with its search structures, which must outlive the object. Many threads may use one object.
class Relocator {
 public:
  /// The nearest obstacle: the closest point of the surface or, for overlapping solids, of the one it is deepest in.
  struct Nearest {
    ClosestPoint closest;  ///< of that surface, or of that solid
    double distance;       ///< [m] negative inside a closed surface
  };

  /// The criterion of contact in one query.
  struct Ball {
    double radius;  ///< [m]
    double offset;  ///< [m] that is added to the radius on relocation, and subtracted in the contact test
  };

  /// Input of the search for a position outside.
  struct Around {
    const Bvh::Nearby& nearby;  ///< of the end of the path
    Vec3d start;                ///< [m] of the path
    Vec3d viewer;               ///< [m] the start, moved off the surface
    Ball ball;                  ///< of the point
  };

  /// Of a surface and its search structures.
  Relocator(const Surface& surface, const Bvh& bvh, const Solids& solids) : surface_(&surface), bvh_(&bvh), solids_(&solids) {}

  /// The point of a triangle that is closest to `point`.
  ClosestPoint closest_on(int triangle, const Vec3d& point) const;

  /// 1 outside, -1 inside (or behind), 0 if undetermined: beyond the boundary of an open surface.
  int side(const ClosestPoint& closest, const Vec3d& point, std::size_t& tested) const;

  /// Unit outward direction at a closest point: along the line to `point`, or the pseudonormal if that line is shorter than `tiny` [m].
  Vec3d outward(const ClosestPoint& closest, const Vec3d& point, double tiny) const;

  /// Inside, or nearer than `distance` [m]; for an open surface, in front of it and nearer.
  bool too_near(const ClosestPoint& closest, const Vec3d& point, double distance, std::size_t& tested) const;

  /// `guess`: a triangle expected to be near, or -1. Nothing for a point that is not a number.
  std::optional<Nearest> nearest(const Vec3d& point, int guess, std::size_t& tested) const { return nearest(point, {}, guess, tested); }
  /// The same with cached surroundings.
  std::optional<Nearest> nearest(const Vec3d& point, const Bvh::Nearby& nearby, int guess, std::size_t& tested) const;

  /// Replaces the position of first contact by the relocated one. `end` [m]: of the path, with its closest point.
  void relocate(BodyFrameContact& contact, const Vec3d& end, const ClosestPoint& at_end, const Around& around, std::size_t& tested) const;

  /// True if a ball was in contact at the start of its path and slid without hitting another part. `normal`, `distance` [m]: of the surface
  /// at the start, outward and from the centre of the ball.
  static bool slid_along(const Vec3d& normal, double distance, const BodyFrameContact& contact, const Path& path, const Ball& ball);

  /// End position of a point that moves from `from` towards `to`, as SlidingSurface::slide. `offset`: that of the query.
  Vec3d slide(const Vec3d& from, const Vec3d& to, double radius, double offset) const;

  const Surface& surface() const { return *surface_; }  ///< in the frame of the positions
  const Solids& solids() const { return *solids_; }     ///< of that surface

 protected:
  const Bvh& bvh() const { return *bvh_; }  ///< of that surface

 private:
  /// A position outside, and the nearest surface there.
  struct Place {
    Vec3d point;      // [m]
    Vec3d direction;  // unit, out of the surface
    int triangle;
  };

  std::optional<ClosestPoint> closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, const ClosestPoint& closest, std::size_t& tested) const;
  std::optional<Place> first_place(const BodyFrameContact& contact, const Vec3d& end, const ClosestPoint& at_end, const Around& around,
                                   std::size_t& tested) const;
  std::optional<Place> clear_place(Place place, const Vec3d& wanted, const Around& around, std::size_t& tested) const;

  const Surface* surface_;
  const Bvh* bvh_;
  const Solids* solids_;
};

}  // namespace fccda
