/// Fixed particles, from its setup.
#pragma once

#include "perimpact/boundary_conditions/actions/prescribed_displacement.hpp"
#include "perimpact/boundary_conditions/actions/site.hpp"
#include "perimpact/boundary_conditions/fixed/setup.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table.
PrescribedDisplacement make_boundary(const FixedSetup& setup, const BoundarySite& site);

}  // namespace perimpact
