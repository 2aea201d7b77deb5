/// The spatial pressure-area curve of one pressure distribution: mean pressure over areas nested around the highest one. (Ice
/// engineers distinguish it from the process curve, the mean pressure over the whole contact as that grows in time: C. Daley, A study
/// of the process-spatial link in ice pressure-area relationships, PERD/CHC Report 7-108, 2004, section 2.)
///
/// The area grows from the most loaded panel, each time by the neighbour with the highest pressure; among equal ones (panels without
/// load between two that have some) by the nearest to the first panel. It ends with the last loaded panel that hangs together with the first.
#pragma once

#include <span>
#include <vector>

#include "mesh/panel_faces.hpp"

namespace fccda {

struct NestedArea {
  double area;           ///< [m²]
  double mean_pressure;  ///< [Pa] over it
};

/// At most `count` of the nested areas, evenly spread on a logarithmic scale from the first panel to all; none where no pressure [Pa]
/// of a panel is above 0.
std::vector<NestedArea> nested_areas(const PanelFaces& faces, std::span<const double> pressure, std::size_t count);

}  // namespace fccda
