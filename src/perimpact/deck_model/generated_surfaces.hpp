/// Hull and propeller surfaces generated from main dimensions (docs/guide/shapes.md).
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "perimpact/deck_model/solids.hpp"

namespace perimpact {

/// Ship hull. Axes: x aft from the intersection of stem and waterline, y to starboard, z up from the waterline.
struct HullSurface {
  static constexpr std::string_view name = "hull";
  double length{}, breadth{}, draft{};            ///< [m]
  double stem_angle{}, waterline_angle{};         ///< [rad]
  double fullness = 2;                            ///< exponent of the bow's waterlines
  std::optional<double> bilge_radius, freeboard;  ///< [m]
  std::optional<double> stem_radius;              ///< [m]
  std::optional<double> stern_angle;              ///< [rad]
  std::optional<double> stern_waterline_angle;    ///< [rad]
  double flare = 0;                               ///< [rad]
  double edge_length{};                           ///< [m]
  std::optional<double> bow_edge_length;          ///< [m]
  static std::span<const Field<HullSurface>> fields();
};

/// Blade sections against radius, in place of the Wageningen series.
struct PropellerSectionsSetup {
  std::vector<double> radius, chord, thickness, pitch;  ///< r/R, c/D, t/D, P/D
  std::vector<double> rake, skew, camber;               ///< over D, [rad], over the chord
  static std::span<const Field<PropellerSectionsSetup>> fields();
};

inline constexpr std::string_view hand_words[] = {"right", "left"};

/// Propeller. The positive direction of the shaft axis is ahead; the centre of the hub is the origin.
struct PropellerSurface {
  static constexpr std::string_view name = "propeller";
  double diameter{};  ///< [m]
  int blades = 4;
  std::optional<double> pitch_ratio, area_ratio;
  double hub_ratio = 0.2;
  std::optional<double> hub_length;  ///< [m]
  double rake = 0, skew = 0;         ///< [rad]
  double thickness_factor = 1, edge_thickness = 0.1;
  Choice hand{hand_words};
  Choice axis{axis_words, 0};
  double edge_length{};                     ///< [m]
  std::optional<double> blade_edge_length;  ///< [m]
  std::optional<PropellerSectionsSetup> sections;
  static std::span<const Field<PropellerSurface>> fields();
};

}  // namespace perimpact
