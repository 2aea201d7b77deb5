/// How regions look.
#pragma once

#include <span>

#include "fccda/region/all_regions.hpp"
#include "fccda/surface/panels.hpp"

namespace fccda {

/// Six quads for each box, facing outward.
Panels panels_of(std::span<const Box> boxes);

/// The faces of a region, facing outward, in the frame of the body; none where there is no bound. Overlapping boxes are shown whole. A
/// circle is shown with 72 edges.
Panels region_panels(const Region& region);

}  // namespace fccda
