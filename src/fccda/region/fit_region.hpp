/// The region that suits a surface, found by itself.
#pragma once

#include <string>

#include "fccda/region/all_regions.hpp"
#include "fccda/surface/surface.hpp"

namespace fccda {

struct FittedRegion {
  Region region;
  std::string choice;  ///< a sentence: what was compared, and what was taken
};

/// One box, several boxes (fit_boxes) or a cylinder with sectors (fit_sectors): the one that costs a point in the bounding box least,
///
///   (time of the region's test) + (share of the bounding box that the region fills) · (time of a look at the surface)
///
/// with the times measured in docs/theory/contact.md, Regions.
FittedRegion fit_region(const Surface& surface);

}  // namespace fccda
