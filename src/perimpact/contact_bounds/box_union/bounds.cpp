#include "perimpact/contact_bounds/box_union/bounds.hpp"

#include <vector>

#include "fccda/contact_bounds/fit_boxes.hpp"

namespace perimpact {

using namespace fccda;

ImpactorBounds make_bounds(const BoxUnionBoundsSetup& setup, const Surface& surface, Beyond beyond) {
  if (!setup.boxes.empty()) {
    std::vector<BoxUnion::Shape> shapes;
    for (const BoundsBoxSetup& box : setup.boxes) shapes.push_back({box.size, box.centre});
    return {BoxUnion(shapes, surface, beyond), ""};
  }
  BoxFit wanted;
  if (setup.count) wanted.most = *setup.count;
  if (setup.gain) wanted.gain = *setup.gain;
  return {BoxUnion(fit_boxes(surface, wanted)), "boxes fitted to the surface"};
}

}  // namespace perimpact
