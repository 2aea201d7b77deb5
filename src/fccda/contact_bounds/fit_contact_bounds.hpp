/// Automatic choice of contact bounds for a surface.
#pragma once

#include <string>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/surface.hpp"

namespace fccda {

struct FittedBounds {
  ContactBounds region;
  std::string choice;  ///< a sentence: the alternatives compared, and the choice
};

/// One box, several boxes (fit_boxes) or a cylinder with sectors (fit_sectors): the bounds with the lowest cost for a point in the bounding
/// box,
///
///   (time of the bounds' test) + (share of the bounding box that they fill) · (time of a query of the surface)
///
/// with the times measured in docs/theory/contact_bounds.md.
FittedBounds fit_contact_bounds(const Surface& surface);

}  // namespace fccda
