/// Floating in still water, from its setup.
#pragma once

#include "perimpact/boundary_conditions/actions/site.hpp"
#include "perimpact/boundary_conditions/floating/floating.hpp"
#include "perimpact/boundary_conditions/floating/setup.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table, and if the body sinks and no level is given.
Floating make_boundary(const FloatingSetup& setup, const BoundarySite& site);

}  // namespace perimpact
