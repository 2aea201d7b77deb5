/// A cylinder and its sectors fitted to a propeller (seed paper, section 3.1, example 3).
#pragma once

#include <optional>

#include "fccda/contact_bounds/cylinder_sectors.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// What is known already; the rest is fitted. Names as in CylinderSectors::Shape. `start_angle` needs `sector_angle`.
struct KnownSectors {
  std::optional<Vec3d> axis, point;
  std::optional<double> radius, length, hub_radius;
  std::optional<int> blades;
  std::optional<double> sector_angle, start_angle;
};

/// The smallest region of this kind that holds the surface, as far as what is given allows.
///   axis     of the three principal axes of the surface's area, the one that leaves the smallest region
///   point    the axis goes through the centroid of the area; the middle of the surface along it
///   radius, length, hub_radius, blades, sector_angle, start_angle    as the surface needs (AnglesTaken)
/// Where gaps between the sectors would save less than a hundredth of the cylinder, it is the whole cylinder.
CylinderSectors::Shape fit_sectors(const Surface& surface, const KnownSectors& known);

}  // namespace fccda
