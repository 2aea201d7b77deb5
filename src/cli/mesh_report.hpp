/// What `perimpact mesh` says of a surface beyond the facts that `check` has too.
#pragma once

#include <optional>
#include <string>

#include "mesh/inspect/self_intersections.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace perimpact {

/// A size that no ship, tool or specimen has, with the scale that was probably meant; nothing otherwise.
std::optional<std::string> unit_suspicion(const fccda::SurfaceReport& report);

/// The weld distance [m] that would close an open surface without losing panels, where there is one of at most 1e-4 of its size.
std::optional<double> closing_weld(const fccda::Panels& panels, const fccda::Surface& surface);

/// Rims, edges of more than two panels, panels that cross, a row each; nothing of a sound closed surface.
std::string defects_text(const fccda::Surface& surface, const fccda::SelfIntersections& folds);

/// The key of the deck that closes a surface whose rims all lie in one of the planes x = 0, y = 0 and z = 0, as those of half a ship do; nothing of others.
std::optional<std::string> half_suspicion(const fccda::Surface& surface);

/// The panels against particles of that spacing [m].
std::string spacing_text(const fccda::Surface& surface, const fccda::Bvh& bvh, double spacing);

}  // namespace perimpact
