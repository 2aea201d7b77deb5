/// Checks of a surface for `perimpact mesh`, in addition to the facts that `check` also prints.
#pragma once

#include <optional>
#include <string>

#include "mesh/inspect/self_intersections.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace perimpact {

/// Warning about an implausible size, with the probable scale; empty otherwise.
std::optional<std::string> unit_suspicion(const fccda::SurfaceReport& report);

/// The welding tolerance [m] that closes an open surface without losing panels, if one of at most 1e-4 of its size exists.
std::optional<double> closing_weld(const fccda::Panels& panels, const fccda::Surface& surface);

/// One row each for boundary loops, non-manifold edges and self-intersections; empty for a watertight surface without defects.
std::string defects_text(const fccda::Surface& surface, const fccda::SelfIntersections& folds);

/// The deck key that closes a surface whose boundary edges all lie in a plane x = 0, y = 0 or z = 0, as for half a ship; else empty.
std::optional<std::string> half_suspicion(const fccda::Surface& surface);

/// Suitability of the panels for particles of this spacing [m].
std::string spacing_text(const fccda::Surface& surface, const fccda::Bvh& bvh, double spacing);

}  // namespace perimpact
