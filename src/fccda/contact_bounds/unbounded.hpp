/// No bounds: contact counts on the whole surface.
#pragma once

#include <limits>
#include <string_view>

#include "fccda/contact_bounds/path.hpp"

namespace fccda {

class Unbounded {
 public:
  static constexpr std::string_view name = "unbounded";
  static constexpr bool clips() { return false; }
  static constexpr bool contains(const Vec3d&) { return true; }
  static constexpr bool may_touch(const Path&, double) { return true; }
  static constexpr double distance_at_least(const Vec3d&) { return 0; }
  static constexpr double volume() { return std::numeric_limits<double>::infinity(); }
};

}  // namespace fccda
