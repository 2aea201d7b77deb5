/// Pressure, from its setup.
#pragma once

#include "perimpact/boundary_conditions/actions/load.hpp"
#include "perimpact/boundary_conditions/actions/site.hpp"
#include "perimpact/boundary_conditions/pressure/setup.hpp"

namespace perimpact {

/// Throws SetupError for an unknown particle set or an invalid table, and if the area of a point cloud is missing.
Load make_boundary(const PressureSetup& setup, const BoundarySite& site);

}  // namespace perimpact
