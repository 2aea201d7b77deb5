/// Boxes along the axes of the body frame: one (seed paper, section 3.1, example 1) or several together (example 2). They promise what
/// every region does (all_regions.hpp).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "fccda/contact_bounds/exceeding_panels.hpp"
#include "fccda/contact_bounds/path.hpp"
#include "mesh/surface.hpp"

namespace fccda {

class BoxUnion {
 public:
  static constexpr std::string_view name = "box_union";

  struct Shape {
    Vec3d size{};    ///< [m]
    Vec3d centre{};  ///< [m] from the origin of the body frame
  };

  /// Boxes as wanted; they may overlap. Exact to the widening: a panel that lies partly in one box and partly in its neighbour is inside. Throws
  /// InputError where the surface sticks out and `beyond` is error, or where no panel reaches into one of the boxes.
  BoxUnion(std::span<const Shape> shapes, const Surface& surface, Beyond beyond);
  BoxUnion(const Shape& shape, const Surface& surface, Beyond beyond) : BoxUnion(std::span(&shape, 1), surface, beyond) {}

  /// Boxes that are known to hold the surface (fit_boxes).
  explicit BoxUnion(std::vector<Box> boxes);

  bool clips() const { return clips_; }                   ///< some of the surface lies outside, where it is not felt
  bool contains(const Vec3d& point) const;                ///< a place where contact counts; the boxes' faces belong to it
  bool may_touch(const Path& path, double margin) const;  ///< false: the path surely stays further than `margin` [m] from the boxes
  double distance_at_least(const Vec3d& point) const;     ///< [m] from the nearest box; 0 inside
  double volume() const;                                  ///< [m³]; what boxes share counts once

  std::span<const Box> boxes() const { return boxes_; }

 private:
  std::vector<Box> boxes_;  // the wanted ones, widened
  Box bounds_;              // of all
  bool clips_ = false;
};

}  // namespace fccda
