/// What a detector finds.
#pragma once

#include <cstddef>

#include "base/vec3.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

/// The surface as what a point slides on.
class SlidingSurface {
 public:
  /// Where a point gets to that a detector relocated to `from` and friction moves on to `to` [m], places of the world with the body at
  /// `pose`. `radius` [m]: of contact, of the point. It goes straight until the surface is in its way, and along that from there on, in each part by the
  /// projection of what is left of the whole way. So it is never nearer to the surface than it may be, crosses nothing, and goes no further than it was to.
  /// `to` to the bit where nothing is in the way.
  virtual Vec3d slide(const Pose& pose, const Vec3d& from, const Vec3d& to, double radius) const = 0;

 protected:
  SlidingSurface() = default;
  SlidingSurface(const SlidingSurface&) = default;
  SlidingSurface& operator=(const SlidingSurface&) = default;
  ~SlidingSurface() = default;
};

/// A point that struck the surface during a step. Positions and directions are of the world frame, with the surface where it is
/// at the end of the step.
struct Contact {
  std::size_t point = 0;
  int panel = -1;            ///< that the point is put back on, numbered as in the file; -1 where the surface has no panels
  double time_fraction = 0;  ///< of first touch, 0 at t0 to 1 at t1; at which the ball, or the point, meets the surface
  Vec3d hit{};               ///< [m] of the surface, where it was first touched
  Vec3d normal{};            ///< unit, out of the surface, at the place the point is put back on
  Vec3d relocation{};        ///< [m] where the point belongs at t1: at the contact radius from the surface
  double depth = 0;          ///< [m] from where the point had gone to the relocation
  double radius = 0;         ///< [m] contact radius of the point
  /// Unit, out of the surface, at the place where the point was at t0, with the surface where it was then; 0 where the point was not in contact there, or
  /// slid into another part of the surface. A push along it does no work on sliding (respond.hpp).
  Vec3d normal_t0{};
  /// Where friction may take the point; the detector itself, which must be there when contacts are responded to. Null where nothing can be
  /// in the way: on a sphere or cylinder, which falls away to all sides.
  const SlidingSurface* sliding = nullptr;
};

/// How much work a detection was, for the run report.
struct Effort {
  std::size_t points_in_bounds = 0;  ///< whose path may touch the region
  std::size_t points_asked = 0;      ///< whose distance to the surface was looked up
  std::size_t panels_asked = 0;      ///< pairs of point and triangle (or panel) that were computed

  Effort& operator+=(const Effort& b) {
    points_in_bounds += b.points_in_bounds, points_asked += b.points_asked, panels_asked += b.panels_asked;
    return *this;
  }

  /// As core/state.hpp says.
  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor("points_in_bounds", points_in_bounds);
    visitor("points_asked", points_asked);
    visitor("panels_asked", panels_asked);
  }
};

}  // namespace fccda
