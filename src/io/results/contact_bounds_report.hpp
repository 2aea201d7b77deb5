/// An impactor's region, for run.json and for `check`.
#pragma once

#include <optional>
#include <string>

#include "io/output/json.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// "none", "box", "box_union" or "cylinder_sectors"; whatever the deck said, what it came to.
std::string bounds_kind(const fccda::ContactBounds& region);

/// Its volume over that of the surface's bounding box; nothing where there is no region, or the surface is flat.
std::optional<double> share_of_bounding_box(const Impactor& impactor);

output::Json contact_bounds_report(const Impactor& impactor);

}  // namespace perimpact
