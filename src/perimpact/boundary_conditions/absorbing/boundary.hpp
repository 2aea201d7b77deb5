/// Absorbing layer, from its setup.
#pragma once

#include "perimpact/boundary_conditions/absorbing/absorbing.hpp"
#include "perimpact/boundary_conditions/absorbing/setup.hpp"
#include "perimpact/boundary_conditions/actions/site.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table, and if the body continues beyond the layer.
Absorbing make_boundary(const AbsorbingSetup& setup, const BoundarySite& site);

}  // namespace perimpact
