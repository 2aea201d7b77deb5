/// Points at equal distances along x: a row of a lattice, which a solid answers for at once.
#pragma once

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

struct Row {
  Vec3d first{};       ///< [m]
  double spacing = 0;  ///< [m]
  int count = 1;

  double x(int i) const { return first.x + i * spacing; }
  Vec3d point(int i) const { return {x(i), first.y, first.z}; }
};

}  // namespace perimpact
