/// Hydrostatics: the volume of a closed surface below a plane, and its centre.
///
/// With the outward normal n, the plane's normal u, positions p relative to a point of the plane, the depth s = -u·p, and V the volume
/// below the plane, the divergence theorem gives integrals over the wetted surface alone, since s = 0 on the lid in the plane:
///
///   ∫_V dV   = -∫ s n·u dA                        [m³]
///   ∫_V p dV = -∫ (s p + ½ s² u) n·u dA           [m⁴]
///   area of the lid, ∫ dA_lid = -∫ n·u dA         [m²]
///
/// The integrands are polynomials on a triangle and are integrated exactly; triangles that intersect the plane are clipped.
#pragma once

#include "mesh/surface.hpp"

namespace fccda {

/// The plane up·x = height in the frame of the surface; the volume below it is submerged.
struct Level {
  Vec3d up{0, 0, 1};  ///< unit vector
  double height = 0;  ///< [m]
};

/// The part of a volume below a level.
struct SubmergedVolume {
  double volume = 0;      ///< [m³]
  Vec3d centre{};         ///< [m] of that volume, the centre of buoyancy; 0 if it is empty
  double waterplane = 0;  ///< [m²] waterplane area: the derivative of the volume with respect to the height
};

/// Expects a closed surface. The shared volume of overlapping components counts twice. Bitwise reproducible across thread counts.
SubmergedVolume submerged(const Surface& surface, const Level& level);

}  // namespace fccda
