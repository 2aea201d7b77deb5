/// Contact bounds of a propeller: a cylinder about its axis, and within it a fan of a hub and equal sectors that rotate with the blades (Zhang
/// et al., section 3.1, example 3). The fan is at rest in the body frame. It gives the guarantees of all contact bounds
/// (all_contact_bounds.hpp).
///
/// The test has two stages, as in the paper: first the cylinder, then the fan. A fan without gaps (sectors that cover the circle, or of half a
/// turn or more) is the whole cylinder.
///
/// Whether a panel lies in the fan is determined by halving its triangles until each piece lies in the hub or in one sector, or is shorter than
/// a slack of a thousandth of the radius. Queries of hub and sectors add that slack, so nothing between them is missed.
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

/// Contact bounds of a cylinder with a hub and equal sectors.
class CylinderSectors {
 public:
  static constexpr std::string_view name = "cylinder_sectors";  ///< its key in a deck

  /// Dimensions, in the body frame.
  struct Shape {
    Vec3d axis{0, 0, 1};      ///< direction of the cylinder; need not be a unit vector
    Vec3d point{};            ///< [m] centre of the cylinder
    double radius = 0;        ///< [m] positive
    double length = 0;        ///< [m] at least 0
    double hub_radius = 0;    ///< [m] occupied at all angles; at least 0
    int blades = 1;           ///< sectors at equal angles, 1 to 1000
    double sector_angle = 0;  ///< [rad] of each, from 0 to 2π
    double start_angle = 0;   ///< [rad] begin of the first; see CylinderFrame

    bool has_gaps() const;  ///< the sectors leave part of the circle free
  };

  /// Throws InputError if a number of the shape is not finite or out of its range, the surface extends beyond the bounds and `beyond` is error, or
  /// no panel reaches into them.
  CylinderSectors(const Shape& shape, const Surface& surface, Beyond beyond);

  bool clips() const { return clips_; }                     ///< part of the surface lies outside, where contact is ignored
  bool contains(const Vec3d& point) const;                  ///< contact counts at this position
  bool may_contact(const Path& path, double margin) const;  ///< false: the path certainly stays farther than `margin` [m] from the bounds
  double distance_at_least(const Vec3d& point) const;       ///< a lower bound [m]; 0 inside
  double volume() const { return volume_of(shape_); }       ///< [m³]

  const Shape& shape() const { return shape_; }  ///< as specified

  /// Calls visit(name, value) for each number that reports show.
  template <class Visit>
  void visit_facts(const Visit& visit) const {
    visit("axis", shape_.axis), visit("point [m]", shape_.point), visit("radius [m]", shape_.radius), visit("length [m]", shape_.length);
    visit("gaps", shape_.has_gaps());
    if (!shape_.has_gaps()) return;
    visit("hub_radius [m]", shape_.hub_radius), visit("blades", shape_.blades);
    visit("sector_angle [rad]", shape_.sector_angle), visit("start_angle [rad]", shape_.start_angle);
  }
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
  double half_length_;  // [m] as above
  double hub_;          // [m] of the hub; of the cylinder if the fan has no gaps
  std::vector<Wedge> sectors_;
  bool clips_ = false;
};

}  // namespace fccda
