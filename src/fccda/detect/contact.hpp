/// What a detector finds.
#pragma once

#include <cstddef>

#include "fccda/core/vec3.hpp"

namespace fccda {

/// A point that struck the surface during a step. Positions and directions are of the world frame, with the surface where it is
/// at the end of the step.
struct Contact {
  std::size_t point = 0;
  int panel = -1;            ///< that the point is put back on, numbered as in the file; -1 where the surface has no panels
  double time_fraction = 0;  ///< of first touch, 0 at t0 to 1 at t1; a lower bound where the path grazes
  Vec3d hit{};               ///< [m] of the surface, where it was first touched
  Vec3d normal{};            ///< unit, out of the surface, at the place the point is put back on
  Vec3d relocation{};        ///< [m] where the point belongs at t1: at the contact radius from the surface
  double depth = 0;          ///< [m] from where the point had gone to the relocation
};

/// How much work a detection was, for the run report.
struct Effort {
  std::size_t points_in_region = 0;  ///< whose path may touch the region
  std::size_t points_asked = 0;      ///< whose distance to the surface was looked up
  std::size_t panels_asked = 0;      ///< pairs of point and triangle (or panel) that were computed

  Effort& operator+=(const Effort& b) {
    points_in_region += b.points_in_region, points_asked += b.points_asked, panels_asked += b.panels_asked;
    return *this;
  }

  /// As core/state.hpp says.
  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor("points_in_region", points_in_region);
    visitor("points_asked", points_asked);
    visitor("panels_asked", panels_asked);
  }
};

}  // namespace fccda
