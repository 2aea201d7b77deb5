/// The region that a Setup asks for.
#pragma once

#include <string>

#include "fccda/region/all_regions.hpp"
#include "fccda/surface/surface.hpp"
#include "perimpact/setup/setup.hpp"

namespace perimpact {

struct ImpactorRegion {
  fccda::Region region;
  std::string fitted;  ///< what was fitted to the surface, in words; empty where the region was given
};

/// `impactor`: its name. Throws SetupError with the key of the region where the surface sticks out of it, or none of it is inside.
ImpactorRegion region_of(const RegionSetup& setup, const fccda::Surface& surface, const std::string& impactor);

}  // namespace perimpact
