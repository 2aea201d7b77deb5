#include "perimpact/boundary_conditions/fixed/boundary.hpp"

#include <algorithm>
#include <utility>

namespace perimpact {

PrescribedDisplacement make_boundary(const FixedSetup& fixed, const BoundarySite& site) {
  PrescribedDisplacement::Histories histories;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (fixed.directions.empty() || std::find(fixed.directions.begin(), fixed.directions.end(), axis_words[axis]) != fixed.directions.end())
      histories[axis] = DisplacementHistory::rest();
  return PrescribedDisplacement(site.slots(fixed.particle_set), std::move(histories));
}

}  // namespace perimpact
