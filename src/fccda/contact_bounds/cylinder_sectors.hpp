/// A propeller's region: a cylinder about its axis, and in it a fan of a hub and equal sectors that turn with the blades (seed paper,
/// section 3.1, example 3). In the frame of the body the fan stands still. It promises what every region does (all_regions.hpp).
///
/// Two stages, as in the paper: first the cylinder, then the fan. A fan without gaps (sectors that cover the circle, or are half a turn
/// wide and more) is the whole cylinder.
///
/// Whether a panel lies in the fan is found by halving its triangles until each piece lies in the hub or in one sector, or is shorter
/// than a slack of a thousandth of the radius; hub and sectors are asked with that slack added, so nothing between them is lost.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "fccda/contact_bounds/cylinder_frame.hpp"
#include "fccda/contact_bounds/exceeding_panels.hpp"
#include "fccda/contact_bounds/path.hpp"
#include "fccda/contact_bounds/wedge.hpp"
#include "mesh/surface.hpp"

namespace fccda {

class CylinderSectors {
 public:
  static constexpr std::string_view name = "cylinder_sectors";

  struct Shape {
    Vec3d axis{0, 0, 1};
    Vec3d point{};            ///< [m] in the middle of the cylinder
    double radius = 0;        ///< [m]
    double length = 0;        ///< [m]
    double hub_radius = 0;    ///< [m] all around the axis
    int blades = 1;           ///< sectors at equal angles
    double sector_angle = 0;  ///< [rad] of each
    double start_angle = 0;   ///< [rad] where the first begins; see CylinderFrame

    bool has_gaps() const;
  };

  /// Throws InputError where the surface sticks out and `beyond` is error, or where no panel reaches into the region.
  CylinderSectors(const Shape& shape, const Surface& surface, Beyond beyond);

  bool clips() const { return clips_; }                   ///< some of the surface lies outside, where it is not felt
  bool contains(const Vec3d& point) const;                ///< a place where contact counts
  bool may_touch(const Path& path, double margin) const;  ///< false: the path surely stays further than `margin` [m] from the region
  double distance_at_least(const Vec3d& point) const;     ///< a lower bound [m]; 0 inside
  double volume() const { return volume_of(shape_); }     ///< [m³]

  const Shape& shape() const { return shape_; }
  static double volume_of(const Shape& shape);  ///< [m³]

 private:
  using Corners = std::array<Vec3d, 3>;  // of a triangle, in the frame of the cylinder

  bool contains_in_frame(const Vec3d& place, double slack) const;
  double distance_in_frame(const Vec3d& place, double slack) const;
  bool is_in_one_part(const Corners& corners) const;
  bool is_in_fan(const Corners& corners) const;
  bool reaches_in(const Corners& corners) const;

  Shape shape_;
  CylinderFrame frame_;
  double widening_;     // [m]
  double slack_;        // [m]
  double radius_;       // [m] widened
  double half_length_;  // [m] likewise
  double hub_;          // [m] of the hub; of the cylinder where the fan has no gaps
  std::vector<Wedge> sectors_;
  bool clips_ = false;
};

}  // namespace fccda
