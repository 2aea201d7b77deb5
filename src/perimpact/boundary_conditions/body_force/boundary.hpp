/// Body force, from its setup.
#pragma once

#include "perimpact/boundary_conditions/actions/load.hpp"
#include "perimpact/boundary_conditions/actions/site.hpp"
#include "perimpact/boundary_conditions/body_force/setup.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table.
Load make_boundary(const BodyForceSetup& setup, const BoundarySite& site);

}  // namespace perimpact
