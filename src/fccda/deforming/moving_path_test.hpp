/// Contact of one point with a deforming surface over one step, in the world frame. What contact is, and where a point is relocated to, is
/// defined as for rigid surfaces (path_test.hpp); a surface whose vertices move rigidly has the same contacts.
///
/// The point is on the side that it has of the surface at t0. It is in contact if it is inside the surface at t1, or its path meets a moving
/// triangle before (moving_triangle.hpp). Relocation takes place at the surface at t1. Its input is the start of the path as seen from the
/// triangle that is met first: carried along with that triangle from t0 to t1. For a rigid surface this is the start in the body frame.
#pragma once

#include <array>
#include <optional>

#include "fccda/deforming/deforming_surface.hpp"
#include "fccda/detect/path_test.hpp"
#include "fccda/detect/relocator.hpp"

namespace fccda {

/// The path of one point in one step, and what is known of the point.
struct MovingQuery {
  Path path;                ///< in the world frame
  double radius = 0;        ///< [m] of contact
  double offset = 0;        ///< [m]
  double look_ahead = 0;    ///< [m] beyond the contact radius, up to which a distance is worth determining
  bool entered = false;     ///< as in PathQuery
  bool in_contact = false;  ///< as in PathQuery
  bool renumbered = false;  ///< as in PathQuery
};

/// Contact of single paths with a deforming surface in its current step, which must outlive the object; many threads may use one object.
class MovingPathTest {
 public:
  /// Of the step that the surface has begun.
  explicit MovingPathTest(const DeformingSurface& surface);

  /// `guess`: a triangle expected to be near, or -1; updated. Positions of the contact are in the world frame, with the surface at t1.
  PathResult evaluate(const MovingQuery& query, int& guess, Effort& effort) const;

  const Relocator& at_t0() const { return t0_; }  ///< sides of the surface at t0
  const Relocator& at_t1() const { return t1_; }  ///< sides of the surface at t1

 private:
  using Ball = Relocator::Ball;

  /// The path of a ball, from where it is known to be outside.
  struct Approach {
    Path path;
    ClosestPoint at_start, at_end;
    Ball ball;
  };

  /// The start of a path as seen from the surface at t1.
  struct CarriedStart {
    Vec3d place;
    ClosestPoint closest;
  };

  double way(const Path& path) const;
  std::optional<Crossing> first_meeting(const Path& path, double radius, double tolerance, int guess, const Bvh::Nearby& nearby, std::size_t& tested) const;
  bool leads_to_contact(const Approach& approach, const Bvh::Nearby& nearby, std::size_t& tested) const;
  BodyFrameContact first_contact(const Approach& approach, const Bvh::Nearby& nearby, std::size_t& tested) const;
  CarriedStart carried_start(const Approach& approach, const BodyFrameContact& contact, const Bvh::Nearby& nearby, std::size_t& tested) const;
  void relocate(BodyFrameContact& contact, const Approach& approach, bool pushed, const Bvh::Nearby& nearby, std::size_t& tested) const;
  Vec3d carried(int triangle, double fraction, const Vec3d& vector) const;

  const DeformingSurface* surface_;
  Relocator t0_, t1_;
};

}  // namespace fccda
