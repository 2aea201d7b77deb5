/// One box along the axes of the body frame (seed paper, section 3.1, example 1). It promises what every region does (all_regions.hpp).
#pragma once

#include "fccda/core/vec3.hpp"
#include "fccda/region/path.hpp"
#include "fccda/surface/surface.hpp"

namespace fccda {

/// What to do where the surface sticks out of its region.
enum class Beyond { error, clip };

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
