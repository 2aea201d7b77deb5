/// No bounds: contact counts on the whole surface.
#pragma once

#include <limits>
#include <string_view>

#include "fccda/contact_bounds/path.hpp"

namespace fccda {

/// The absence of contact bounds, with their interface.
class Unbounded {
 public:
  static constexpr std::string_view name = "unbounded";                                 ///< for reports
  static constexpr bool clips() { return false; }                                       ///< nothing lies outside
  static constexpr bool contains(const Vec3d&) { return true; }                         ///< contact counts everywhere
  static constexpr bool may_contact(const Path&, double) { return true; }               ///< no path can be excluded
  static constexpr double distance_at_least(const Vec3d&) { return 0; }                 ///< [m]
  static constexpr double volume() { return std::numeric_limits<double>::infinity(); }  ///< [m³]
};

}  // namespace fccda
