/// Bounding regions in the body frame (seed paper, section 3.1): where contact can happen. Particles that do not come near are
/// rejected without a look at the surface.
///
/// Promises of every region (tests/fccda/region/region_contract.test.cpp):
///  1. a path that can come within `margin` of a panel inside the region is never called untouchable;
///  2. nothing changes after construction, so any number of threads may ask at once.
#pragma once

#include <cstddef>

#include "fccda/core/vec3.hpp"
#include "fccda/surface/surface.hpp"

namespace fccda {

/// The straight way of a point in the body frame during a step.
struct Path {
  Vec3d start, end;  ///< [m]

  double length() const { return norm(end - start); }
  Vec3d at(double fraction) const { return start + fraction * (end - start); }
};

/// What to do where the surface sticks out of its region.
enum class Beyond { error, clip };

/// No bound: contact wherever the surface is.
class Unbounded {
 public:
  static constexpr bool clips() { return false; }
  static constexpr bool contains(const Vec3d&) { return true; }
  static constexpr bool may_touch(const Path&, double) { return true; }
  static constexpr double distance_at_least(const Vec3d&) { return 0; }
};

/// One box along the axes of the body frame (example 1 of the paper).
class BoxRegion {
 public:
  struct Shape {
    Vec3d size{};    ///< [m]
    Vec3d centre{};  ///< [m] from the origin of the body frame
  };

  /// Throws InputError where the surface sticks out and `beyond` is error, or where no panel reaches into the box.
  BoxRegion(const Shape& shape, const Surface& surface, Beyond beyond);

  bool clips() const { return clips_; }                   ///< some of the surface lies outside, where it is not felt
  bool contains(const Vec3d& point) const;                ///< a place where contact counts; the box's faces belong to it
  bool may_touch(const Path& path, double margin) const;  ///< false: the path surely stays further than `margin` [m] from the box
  double distance_at_least(const Vec3d& point) const;     ///< [m] from the box; 0 inside

 private:
  Box box_;  // the deck's, widened by rounding
  bool clips_ = false;
};

}  // namespace fccda
