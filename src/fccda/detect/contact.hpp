/// Results of contact detection.
#pragma once

#include <cstddef>

#include "base/vec3.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

/// Interface for sliding: limits the motion of a point along the surface.
class SlidingSurface {
 public:
  /// The end position of a point that a detector relocated to `from` and that friction moves on to `to` [m]; world frame, with the body at
  /// `pose`. `radius` [m]: contact radius of the point. It moves straight until the surface obstructs it, and then along the surface, each
  /// part being the projection of the remaining displacement. So it never comes nearer to the surface than the contact radius, crosses
  /// nothing, and moves no farther than intended. Exactly `to` if unobstructed.
  virtual Vec3d slide(const Pose& pose, const Vec3d& from, const Vec3d& to, double radius) const = 0;

 protected:
  SlidingSurface() = default;
  /// For derived classes only.
  SlidingSurface(const SlidingSurface&) = default;
  /// For derived classes only.
  SlidingSurface& operator=(const SlidingSurface&) = default;
  ~SlidingSurface() = default;
};

/// Contact of one point during a step. Positions and directions are in the world frame, with the surface at its position at the end of the
/// step.
struct Contact {
  std::size_t point = 0;     ///< number of the point
  int panel = -1;            ///< panel of the relocation, numbered as in the file; -1 if the surface has no panels
  double time_fraction = 0;  ///< time of impact, 0 at t0 to 1 at t1: the ball, or the point, first meets the surface
  Vec3d hit{};               ///< [m] point of the surface first in contact
  Vec3d normal{};            ///< unit, out of the surface, at the relocated position
  Vec3d relocation{};        ///< [m] relocated position at t1, at the contact radius from the surface
  double depth = 0;          ///< [m] distance from the unconstrained position to the relocation
  double radius = 0;         ///< [m] contact radius of the point
  /// [m] by how much contact is tested nearer than the contact radius and relocated farther, against the rounding of coordinates in single precision;
  /// 0 in double precision, where it is negligible. The response leaves it out of the velocity (respond.hpp).
  double offset = 0;
  /// Unit, out of the surface, at the position of the point at t0 with the surface at t0; 0 if the point was not in contact there, or slid into
  /// another part of the surface. An impulse along it does no work on sliding (respond.hpp).
  Vec3d normal_t0{};
  /// For sliding with friction: the detector itself, which must exist until the contacts are resolved. Null if nothing can obstruct the point:
  /// a sphere or cylinder is convex.
  const SlidingSurface* sliding = nullptr;
};

/// Amount of work of detections, for the run report.
struct Effort {
  std::size_t points_in_bounds = 0;  ///< points whose path may intersect the contact bounds
  std::size_t points_tested = 0;     ///< points whose distance to the surface was searched
  std::size_t panels_tested = 0;     ///< pairs of point and triangle (or panel) evaluated

  /// Adds the work of another detection.
  Effort& operator+=(const Effort& b) {
    points_in_bounds += b.points_in_bounds, points_tested += b.points_tested, panels_tested += b.panels_tested;
    return *this;
  }

  /// See base/state.hpp.
  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor("points_in_bounds", points_in_bounds);
    visitor("points_tested", points_tested);
    visitor("panels_tested", panels_tested);
  }
};

}  // namespace fccda
