/// Cylinder with sectors, in the deck model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/deck_model/deck_context.hpp"

namespace perimpact {

using fccda::Field;
using fccda::Vec3d;

/// Cylinder with a fan of sectors that rotates with the impactor (example 3). Absent values are fitted to the surface.
struct CylinderSectorsBoundsSetup {
  static constexpr std::string_view name = "cylinder_sectors";
  std::optional<Vec3d> axis;
  std::optional<Vec3d> point;                        ///< [m] from the surface's origin
  std::optional<double> radius, length, hub_radius;  ///< [m]
  std::optional<int> blades;
  std::optional<double> sector_angle, start_angle;  ///< [rad]
  static std::span<const Field<CylinderSectorsBoundsSetup>> fields();
  void check(const DeckContext& deck) const;
  bool is_fitted() const { return true; }
};

}  // namespace perimpact
