/// Prescribed displacement, from its setup.
#pragma once

#include "perimpact/boundary_conditions/actions/prescribed_displacement.hpp"
#include "perimpact/boundary_conditions/actions/site.hpp"
#include "perimpact/boundary_conditions/prescribed/setup.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table.
PrescribedDisplacement make_boundary(const PrescribedSetup& setup, const BoundarySite& site);

}  // namespace perimpact
