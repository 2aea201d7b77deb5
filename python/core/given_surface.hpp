/// The surface of the Python package: from a mesh, shared by detectors.
#pragma once

#include <memory>
#include <utility>

#include "fccda/api/contact_detector.hpp"
#include "mesh/surface.hpp"

namespace perimpact::python {

/// A surface with its search structures, which the first detector builds and all share.
class GivenSurface {
 public:
  explicit GivenSurface(fccda::Surface surface) : surface_(std::make_shared<const fccda::Surface>(std::move(surface))) {}
  const fccda::Surface& surface() const { return *surface_; }
  const fccda::SurfaceReport& report() const { return surface_->report(); }
  const fccda::SharedSurface& shared() {
    if (!shared_) shared_ = fccda::share(surface_);
    return shared_;
  }

 private:
  std::shared_ptr<const fccda::Surface> surface_;
  fccda::SharedSurface shared_;
};

}  // namespace perimpact::python
