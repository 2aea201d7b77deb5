/// A cylinder with sectors fitted to a propeller (Zhang et al., section 3.1, example 3).
#pragma once

#include <optional>

#include "fccda/contact_bounds/cylinder_sectors.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// The prescribed parameters; the others are fitted. Names as in CylinderSectors::Shape. `start_angle` needs `sector_angle`.
struct KnownSectors {
  std::optional<Vec3d> axis, point;
  std::optional<double> radius, length, hub_radius;
  std::optional<int> blades;
  std::optional<double> sector_angle, start_angle;
};

/// The smallest bounds of this kind that contain the surface, given the prescribed parameters.
///   axis     of the three principal axes of the surface's area, the one with the smallest bounds
///   point    on the axis through the centroid of the area; the middle of the surface along it
///   radius, length, hub_radius, blades, sector_angle, start_angle    as required by the surface (AngularOccupancy)
/// If gaps between the sectors would save less than a hundredth of the cylinder, the result is the whole cylinder.
CylinderSectors::Shape fit_sectors(const Surface& surface, const KnownSectors& known);

}  // namespace fccda
