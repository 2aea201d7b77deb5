/// The surface of an impactor with its panels changed as the deck asks: coarsened first, then refined.
#pragma once

#include <optional>

#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

struct CoarseningReport {
  std::size_t panels = 0;    ///< left
  double distance = 0;       ///< [m] proven bound of how far the surface moved
  double volume_change = 0;  ///< [m³] of what it encloses
};

/// What was done to the panels.
struct Remeshing {
  fccda::SurfaceReport given;  ///< the surface as file or shape have it
  std::optional<CoarseningReport> coarsened;
  bool is_refined = false;
};

struct Remeshed {
  fccda::Surface surface;
  std::optional<Remeshing> remeshing;  ///< nothing where the deck asks for none
};

/// Throws SetupError with the key of what cannot be done.
Remeshed remeshed(fccda::Surface given, const ImpactorSetup& setup);

}  // namespace perimpact
