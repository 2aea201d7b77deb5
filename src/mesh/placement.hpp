/// Moves a surface from the coordinates of its file to those it is wanted in.
#pragma once

#include <cstdint>

#include "mesh/panels.hpp"

namespace fccda {

enum class MirrorPlane : std::uint8_t { none, x, y, z };  ///< the plane x = 0, y = 0 or z = 0

struct Placement {
  double scale = 1;                              ///< multiplies coordinates, so that they become metres
  MirrorPlane mirror = MirrorPlane::none;        ///< turns left into right
  MirrorPlane mirror_merge = MirrorPlane::none;  ///< adds the mirror image: of a file that holds half of a ship
  Vec3d rotate{};                                ///< [rad] about the axes x, y and z of the origin, which stay where they are, in this order
  Vec3d translate{};                             ///< [m]
};

/// In the order of the members. Panels that are mirrored are wound the other way, so that their normals go with them; those that are
/// added belong to the parts of those they are images of. A panel in the plane of `complete` and its image lie back to back, and are
/// dropped where the surface is built (duplicates.hpp).
void place(Panels& panels, const Placement& placement);

}  // namespace fccda
