/// No bound: contact wherever the surface is.
#pragma once

#include "fccda/region/path.hpp"

namespace fccda {

class Unbounded {
 public:
  static constexpr bool clips() { return false; }
  static constexpr bool contains(const Vec3d&) { return true; }
  static constexpr bool may_touch(const Path&, double) { return true; }
  static constexpr double distance_at_least(const Vec3d&) { return 0; }
};

}  // namespace fccda
