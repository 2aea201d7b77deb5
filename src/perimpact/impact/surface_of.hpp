/// The surface that a Setup asks for.
#pragma once

#include "fccda/surface/surface.hpp"
#include "perimpact/setup/setup.hpp"

namespace perimpact {

/// Makes or reads the panels and builds the surface. `name`: of the impactor, for messages. Throws SetupError with the key of the
/// surface, saying what is wrong with it.
fccda::Surface surface_of(const SurfaceSetup& setup, const std::string& name);

}  // namespace perimpact
