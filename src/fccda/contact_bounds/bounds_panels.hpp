/// Contact bounds as panels, for output.
#pragma once

#include <span>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/panels.hpp"

namespace fccda {

/// Six quads for each box, facing outward.
Panels panels_of(std::span<const Box> boxes);

/// The faces of contact bounds, facing outward, in the body frame; none if unbounded. Overlapping boxes are included in full. A circle has 72
/// edges.
Panels bounds_panels(const ContactBounds& region);

}  // namespace fccda
