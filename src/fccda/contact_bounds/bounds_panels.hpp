/// How regions look.
#pragma once

#include <span>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "mesh/panels.hpp"

namespace fccda {

/// Six quads for each box, facing outward.
Panels panels_of(std::span<const Box> boxes);

/// The faces of a region, facing outward, in the frame of the body; none where there is no bound. Overlapping boxes are shown whole. A
/// circle is shown with 72 edges.
Panels bounds_panels(const ContactBounds& region);

}  // namespace fccda
