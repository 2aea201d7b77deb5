/// Remeshed surface of an impactor: coarsened first, then refined.
#pragma once

#include <optional>

#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

struct CoarseningReport {
  std::size_t panels = 0;    ///< after coarsening
  double distance = 0;       ///< [m] proven bound of the deviation
  double volume_change = 0;  ///< [m³] of the enclosed volume
};

/// Report of the remeshing.
struct Remeshing {
  fccda::SurfaceReport given;  ///< of the original surface
  std::optional<CoarseningReport> coarsened;
  bool is_refined = false;
};

struct Remeshed {
  fccda::Surface surface;
  std::optional<Remeshing> remeshing;  ///< empty without remeshing
};

/// Throws SetupError with the key of the failing operation.
Remeshed remeshed(fccda::Surface given, const ImpactorSetup& setup);

}  // namespace perimpact
