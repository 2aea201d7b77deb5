/// The angles about an axis that a surface occupies, as a function of the radius.
#pragma once

#include <optional>
#include <vector>

#include "fccda/contact_bounds/cylinder_frame.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Sectors at equal angles that contain everything beyond a hub radius.
struct SectorFan {
  double hub_radius = 0;  ///< [m]
  int blades = 1;
  double sector_angle = 0;  ///< [rad]
  double start_angle = 0;   ///< [rad]
};

class AngularOccupancy {
 public:
  AngularOccupancy(const Surface& surface, const CylinderFrame& frame);

  double radius() const { return radius_; }  ///< [m] of the surface about the axis
  double low() const { return low_; }        ///< [m] its lower end along the axis
  double high() const { return high_; }      ///< [m] its upper end

  /// The fan with the smallest cross-section, over hub radii in 64ths of the radius (or the given one) and one to ten blades (or the given
  /// number). If blades overlap in angle, its sectors cover the circle.
  SectorFan smallest_fan(std::optional<double> hub_radius, std::optional<int> blades) const;

 private:
  /// A piece of the surface, small compared with the radius.
  struct Piece {
    double furthest;      // [m] from the axis
    double start, width;  // [rad]
  };

  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c);
  std::vector<std::vector<bool>> occupied_beyond(const std::vector<double>& hubs, std::size_t bins) const;
  SectorFan fan_around(double hub_radius, int blades) const;

  double radius_ = 0, low_, high_;
  double longest_;  // [m] of pieces
  std::vector<Piece> pieces_;
};

}  // namespace fccda
