/// What part of a closed surface lies under a plane, and where its middle is: hydrostatics.
///
/// With the outward normal n, the plane's normal u, places p from a point of the plane, the depth s = -u·p, and V the part of the volume
/// under the plane, the divergence theorem gives integrals over the wet part of the surface alone, for on the lid in the plane s is 0:
///
///   ∫_V dV   = -∫ s n·u dA                        [m³]
///   ∫_V p dV = -∫ (s p + ½ s² u) n·u dA           [m⁴]
///   area of the lid, ∫ dA_lid = -∫ n·u dA         [m²]
///
/// The integrands are polynomials on a triangle and are integrated exactly; triangles that the plane cuts are clipped.
#pragma once

#include "mesh/surface.hpp"

namespace fccda {

/// The plane up·x = height in the frame of the surface, and what lies under it.
struct Level {
  Vec3d up{0, 0, 1};  ///< of length 1
  double height = 0;  ///< [m]
};

struct SubmergedVolume {
  double volume = 0;      ///< [m³]
  Vec3d centre{};         ///< [m] of that volume, the centre of buoyancy; 0 where there is none
  double waterplane = 0;  ///< [m²] of the plane inside the surface: how fast the volume grows with the height
};

/// Of a closed surface. What overlapping components share counts twice. The same bits for any number of threads.
SubmergedVolume submerged(const Surface& surface, const Level& level);

}  // namespace fccda
