/// Equally spaced points along x: a row of a lattice, tested by a solid at once.
#pragma once

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

struct Row {
  Vec3d first{};       ///< [m] point -begin, of the row of an undivided lattice
  double spacing = 0;  ///< [m]
  int count = 1;
  int begin = 0;

  double x(int i) const { return first.x + (begin + i) * spacing; }
  Vec3d point(int i) const { return {x(i), first.y, first.z}; }
};

}  // namespace perimpact
