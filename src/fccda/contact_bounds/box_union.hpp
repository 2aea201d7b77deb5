/// Axis-aligned boxes in the body frame: one (Zhang et al., section 3.1, example 1) or several (example 2). They give the guarantees of all
/// contact bounds (all_contact_bounds.hpp).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "fccda/contact_bounds/exceeding_panels.hpp"
#include "fccda/contact_bounds/path.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Contact bounds of axis-aligned boxes.
class BoxUnion {
 public:
  static constexpr std::string_view name = "box_union";  ///< its key in a deck

  /// One box as specified.
  struct Shape {
    Vec3d size{};    ///< [m]
    Vec3d centre{};  ///< [m] from the origin of the body frame
  };

  /// Boxes as specified; they may overlap. A panel partly in one box and partly in its neighbour is inside (exact up to the widening). Throws
  /// InputError if there are none, a number is not finite, an edge length is not positive, the surface extends beyond them and `beyond` is error, or
  /// no panel reaches into one of the boxes.
  BoxUnion(std::span<const Shape> shapes, const Surface& surface, Beyond beyond);
  /// The same for a single box.
  BoxUnion(const Shape& shape, const Surface& surface, Beyond beyond) : BoxUnion(std::span(&shape, 1), surface, beyond) {}

  /// Boxes that are known to contain the surface (fit_boxes).
  explicit BoxUnion(std::vector<Box> boxes);

  bool clips() const { return clips_; }                     ///< part of the surface lies outside, where contact is ignored
  bool contains(const Vec3d& point) const;                  ///< contact counts at this position; the boxes' faces belong to them
  bool may_contact(const Path& path, double margin) const;  ///< false: the path certainly stays farther than `margin` [m] from the boxes
  double distance_at_least(const Vec3d& point) const;       ///< [m] from the nearest box; 0 inside
  double volume() const;                                    ///< [m³]; the shared volume of boxes counts once

  std::span<const Box> boxes() const { return boxes_; }  ///< [m] as specified, slightly widened against rounding

 private:
  std::vector<Box> boxes_;  // as specified, widened
  Box bounds_;              // of all
  bool clips_ = false;
};

}  // namespace fccda
