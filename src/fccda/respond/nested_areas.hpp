/// The spatial pressure-area curve of one pressure distribution: mean pressure over areas nested around the peak pressure. It
/// differs from the process curve, the mean pressure over the whole contact area as that grows in time (C. Daley, A study of the
/// process-spatial link in ice pressure-area relationships, PERD/CHC Report 7-108, 2004, section 2).
///
/// The area grows from the panel of highest pressure, each time by the neighbour with the highest pressure. Ties, as among unloaded panels
/// between loaded ones, go to the panel nearest to the first. The last area ends with the last loaded panel connected to the first.
#pragma once

#include <span>
#include <vector>

#include "mesh/panel_faces.hpp"

namespace fccda {

struct NestedArea {
  double area;           ///< [m²]
  double mean_pressure;  ///< [Pa] over it
};

/// Returns at most `count` of the nested areas, evenly spaced on a logarithmic scale from the first panel to all; empty if no panel has a
/// pressure [Pa] above 0.
std::vector<NestedArea> nested_areas(const PanelFaces& faces, std::span<const double> pressure, std::size_t count);

}  // namespace fccda
