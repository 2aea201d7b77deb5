/// The region that a Setup asks for.
#pragma once

#include <string>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

struct ImpactorBounds {
  fccda::ContactBounds region;
  std::string fitted;  ///< what was fitted to the surface, in words; empty where the region was given
};

/// `impactor`: its name. Throws SetupError with the key of the region where the surface sticks out of it, or none of it is inside.
ImpactorBounds contact_bounds_of(const ContactBoundsSetup& setup, const fccda::Surface& surface, const std::string& impactor);

}  // namespace perimpact
