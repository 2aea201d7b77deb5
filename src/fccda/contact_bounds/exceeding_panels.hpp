/// Panels that extend beyond the contact bounds.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "mesh/surface.hpp"

namespace fccda {

/// Treatment of a surface that extends beyond its contact bounds: an error, or contact outside is ignored.
enum class Beyond { error, clip };

/// [m] Widening of contact bounds. A crossing near an edge may be found up to 1e-9 of the edge length beside the panel (front_crossing), so
/// outside bounds that fit exactly; rounding of coordinates is far smaller.
inline double widening(const Surface& surface) {
  return 1e-8 * std::max(largest_magnitude(surface.report().bounds.low), largest_magnitude(surface.report().bounds.high));
}

/// Panels that extend beyond contact bounds, for the message of the error.
struct ExceedingPanels {
  std::set<int> panels;  ///< numbered as in the file
  double furthest = 0;   ///< [m] from the bounds

  /// Adds a panel that extends beyond by `distance` [m].
  void add(int panel, double distance) {
    panels.insert(panel);
    furthest = std::max(furthest, distance);
  }
};

/// Throws InputError: "contact bounds: 2 of 9 panels extend beyond the box by up to 0.05 m (panels 3, 4), …; enlarge the box, or …". `region`:
/// the name of the bounds, `remedy`: how to make them contain the surface.
[[noreturn]] void refuse(const ExceedingPanels& out, const Surface& surface, std::string_view region, std::string_view remedy);

}  // namespace fccda
