/// Builds the surface of a Setup.
#pragma once

#include <cstddef>
#include <memory>

#include "mesh/defects.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

/// Error of an invalid surface with its defective panels, so that they can be written to a file.
class DefectiveSurface : public SetupError {
 public:
  DefectiveSurface(std::string key, std::string impactor, fccda::Panels panels, const fccda::SurfaceError& error)
      : SetupError(std::move(key), error),
        impactor_(std::move(impactor)),
        panels_(std::make_shared<const fccda::Panels>(std::move(panels))),
        defect_(std::make_shared<const fccda::Defect>(error.defect())) {}

  const std::string& impactor() const { return impactor_; }
  const fccda::Panels& panels() const { return *panels_; }
  const fccda::Defect& defect() const { return *defect_; }

 private:
  std::string impactor_;
  std::shared_ptr<const fccda::Panels> panels_;  // shared: exceptions are copied
  std::shared_ptr<const fccda::Defect> defect_;
};

struct GivenSurface {
  fccda::Surface surface;
  std::size_t crossing_panels = 0;  ///< intersecting panels; checked for files only
};

/// Generates or reads the panels and builds the surface. `name`: of the impactor, for messages. Throws SetupError with the key of the
/// surface; DefectiveSurface if the defective panels are known.
GivenSurface surface_of(const SurfaceSetup& setup, const std::string& name);

}  // namespace perimpact
