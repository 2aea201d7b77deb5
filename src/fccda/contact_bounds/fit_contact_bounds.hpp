/// The region that suits a surface, found by itself.
#pragma once

#include <string>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct FittedBounds {
  ContactBounds region;
  std::string choice;  ///< a sentence: what was compared, and what was taken
};

/// One box, several boxes (fit_boxes) or a cylinder with sectors (fit_sectors): the one that costs a point in the bounding box least,
///
///   (time of the region's test) + (share of the bounding box that the region fills) · (time of a look at the surface)
///
/// with the times measured in docs/theory/contact.md, Regions.
FittedBounds fit_contact_bounds(const Surface& surface);

}  // namespace fccda
