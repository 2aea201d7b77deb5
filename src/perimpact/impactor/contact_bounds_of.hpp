/// Builds the contact bounds of a Setup.
#pragma once

#include <string>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/surface.hpp"
#include "perimpact/contact_bounds/impactor_bounds.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// `impactor`: its name. Throws SetupError with the key of the bounds if the surface exceeds them, or is entirely outside.
ImpactorBounds contact_bounds_of(const ContactBoundsSetup& setup, const fccda::Surface& surface, const std::string& impactor);

}  // namespace perimpact
