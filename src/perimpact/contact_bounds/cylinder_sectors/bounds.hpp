/// Cylinder with sectors, from the setup.
#pragma once

#include "mesh/surface.hpp"
#include "perimpact/contact_bounds/cylinder_sectors/setup.hpp"
#include "perimpact/contact_bounds/impactor_bounds.hpp"

namespace perimpact {

/// Throws InputError if the surface exceeds the bounds and `beyond` is error, or is entirely outside.
ImpactorBounds make_bounds(const CylinderSectorsBoundsSetup& setup, const fccda::Surface& surface, fccda::Beyond beyond);

}  // namespace perimpact
