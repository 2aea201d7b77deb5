/// Boxes fitted to a surface, with little unused space (Zhang et al., section 3.1, example 2).
#pragma once

#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct BoxFit {
  int most = 32;        ///< boxes
  double gain = 0.003;  ///< a split must save this share of the bounding box: the cost of testing another box (fit_contact_bounds.hpp)
};

/// Starts from the bounding box and repeatedly splits the box with the largest saving of volume. A split is one of 15 equidistant planes
/// across an axis, with tight boxes around the contents of its two sides. Panels are cut by the planes, so the boxes are tight and contain
/// every point of the surface, and for a closed one the enclosed volume too: a particle pinched deep inside remains within reach. The boxes
/// are widened (exceeding_panels.hpp).
std::vector<Box> fit_boxes(const Surface& surface, const BoxFit& wanted);

}  // namespace fccda
