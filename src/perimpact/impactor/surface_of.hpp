/// The surface that a Setup asks for.
#pragma once

#include <cstddef>
#include <memory>

#include "mesh/defects.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

/// A surface that cannot be used because of some of its panels, with these, so that a picture of them can be written.
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
  std::size_t crossing_panels = 0;  ///< that go through one another; looked for in files only
};

/// Makes or reads the panels and builds the surface. `name`: of the impactor, for messages. Throws SetupError with the key of the
/// surface, saying what is wrong with it; DefectiveSurface where panels can be named.
GivenSurface surface_of(const SurfaceSetup& setup, const std::string& name);

}  // namespace perimpact
