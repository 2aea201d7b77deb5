/// Contact bounds chosen for the surface, from the setup.
#pragma once

#include "mesh/surface.hpp"
#include "perimpact/contact_bounds/automatic/setup.hpp"
#include "perimpact/contact_bounds/impactor_bounds.hpp"

namespace perimpact {

/// Throws InputError if the surface exceeds the bounds and `beyond` is error, or is entirely outside.
ImpactorBounds make_bounds(const AutoBoundsSetup& setup, const fccda::Surface& surface, fccda::Beyond beyond);

}  // namespace perimpact
