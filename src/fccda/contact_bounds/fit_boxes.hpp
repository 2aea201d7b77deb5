/// Boxes fitted to a surface: little space around it that is not needed (seed paper, section 3.1, example 2).
#pragma once

#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct BoxFit {
  int most = 32;        ///< boxes
  double gain = 0.003;  ///< a split must save this share of the bounding box: what the test of a further box costs (fit_region.hpp)
};

/// Starts from the bounding box and splits, again and again, the box whose best split saves most volume. A split is a plane across an
/// axis, one of 15 at equal distances, with the tight boxes around what lies on its two sides. Panels are cut by the planes, so the
/// boxes are tight and hold every point of the surface, and of a closed one everything inside too: a particle pinched deep inside is
/// not out of reach. Widened (sticking_out.hpp).
std::vector<Box> fit_boxes(const Surface& surface, const BoxFit& wanted);

}  // namespace fccda
