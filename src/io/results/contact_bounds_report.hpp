/// Report of an impactor's contact bounds, for run.json and `check`.
#pragma once

#include <optional>
#include <string>

#include "io/output/json.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Kind of the resulting contact bounds: "none", "box", "box_union" or "cylinder_sectors".
std::string bounds_kind(const fccda::ContactBounds& region);

/// Volume of the contact bounds relative to the bounding box of the surface; nothing without bounds, or for a flat surface.
std::optional<double> share_of_bounding_box(const Impactor& impactor);

output::Json contact_bounds_report(const Impactor& impactor);

}  // namespace perimpact
