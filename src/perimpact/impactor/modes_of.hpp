/// Vibration modes of an impactor from its Setup.
#pragma once

#include "fccda/elastic/modes.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// Reads the modes of an elastic impactor, on the vertices of its surface's panels, with the damping of the deck where it gives one and without the modes above
/// its highest frequency. Expects `setup.elastic`. Throws SetupError with its key where the file is refused (fccda/modes), a mode is a rigid motion that the
/// free degrees of freedom have already, or no mode is left.
fccda::Modes modes_of(const ImpactorSetup& setup, const fccda::Surface& surface);

}  // namespace perimpact
