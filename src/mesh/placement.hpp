/// Transformation of a surface from file coordinates to model coordinates.
#pragma once

#include <cstdint>

#include "mesh/panels.hpp"

namespace fccda {

enum class MirrorPlane : std::uint8_t { none, x, y, z };  ///< the plane x = 0, y = 0 or z = 0

struct Placement {
  double scale = 1;                              ///< factor on coordinates, to convert them to metres
  MirrorPlane mirror = MirrorPlane::none;        ///< reflects the surface
  MirrorPlane mirror_merge = MirrorPlane::none;  ///< adds the mirror image, for a file of half a ship
  Vec3d rotate{};                                ///< [rad] about the fixed axes x, y and z through the origin, in this order
  Vec3d translate{};                             ///< [m]
};

/// Applies the members in order. Mirrored panels reverse their winding, so that their normals are mirrored too. Added panels belong to the
/// parts of their originals. A panel in the plane of `mirror_merge` and its image lie back to back, and are dropped when the surface is
/// built (duplicates.hpp).
void place(Panels& panels, const Placement& placement);

}  // namespace fccda
