/// A surface with its search structures: the BVH of its triangles, and the triangles that may be buried in another solid. Immutable after
/// construction, so any number of detectors may share one, whatever their contact radius, points or body, and any number of threads may
/// read it.
///
///   const auto hull = share(Surface(read_panels("hull.stl")));
///   ContactDetector water(hull, {.radius = 0.01}), ice(hull, {.radius = 0.05});
#pragma once

#include <memory>
#include <utility>

#include "mesh/search/bvh.hpp"
#include "mesh/search/solids.hpp"
#include "mesh/surface.hpp"

namespace fccda {

class IndexedSurface {
 public:
  explicit IndexedSurface(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)), bvh_(*surface_), solids_(*surface_) {}

  const Surface& surface() const { return *surface_; }
  const Bvh& bvh() const { return bvh_; }
  const Solids& solids() const { return solids_; }

 private:
  std::shared_ptr<const Surface> surface_;
  Bvh bvh_;
  Solids solids_;
};

using SharedSurface = std::shared_ptr<const IndexedSurface>;

inline SharedSurface share(std::shared_ptr<const Surface> surface) { return std::make_shared<const IndexedSurface>(std::move(surface)); }
inline SharedSurface share(Surface surface) { return share(std::make_shared<const Surface>(std::move(surface))); }

}  // namespace fccda
