/// What holds a surface, and the part that sticks out.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "mesh/surface.hpp"

namespace fccda {

/// What to do where the surface sticks out of its region.
enum class Beyond { error, clip };

/// [m] by which regions are widened. Where a path goes through a surface near an edge, it may be found to do so up to 1e-9 of the edge
/// beside the panel (front_crossing), so outside a region that fits exactly; rounding of coordinates is far less.
inline double widening(const Surface& surface) {
  return 1e-8 * std::max(largest_magnitude(surface.report().bounds.low), largest_magnitude(surface.report().bounds.high));
}

struct ExceedingPanels {
  std::set<int> panels;  ///< numbered as in the file
  double furthest = 0;   ///< [m] from the region

  void add(int panel, double distance) {
    panels.insert(panel);
    furthest = std::max(furthest, distance);
  }
};

/// Throws InputError: "region: 2 of 9 panels stick out of the box by up to 0.05 m (panels 3, 4), …; enlarge the box, or …". `region`: what
/// it is called, `remedy`: what makes it hold the surface.
[[noreturn]] void refuse(const ExceedingPanels& out, const Surface& surface, std::string_view region, std::string_view remedy);

}  // namespace fccda
