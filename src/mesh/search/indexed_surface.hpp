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

/// A surface with its search structures.
class IndexedSurface {
 public:
  /// Builds the search structures.
  explicit IndexedSurface(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)), bvh_(*surface_), solids_(*surface_) {}

  const Surface& surface() const { return *surface_; }  ///< in the body frame
  const Bvh& bvh() const { return bvh_; }               ///< of all triangles
  const Solids& solids() const { return solids_; }      ///< of overlapping closed parts

 private:
  std::shared_ptr<const Surface> surface_;
  Bvh bvh_;
  Solids solids_;
};

/// What detectors hold of a surface.
using SharedSurface = std::shared_ptr<const IndexedSurface>;

/// Builds the search structures of a surface once, for any number of detectors.
inline SharedSurface share(std::shared_ptr<const Surface> surface) { return std::make_shared<const IndexedSurface>(std::move(surface)); }
/// The same for a surface that only detectors use.
inline SharedSurface share(Surface surface) { return share(std::make_shared<const Surface>(std::move(surface))); }

}  // namespace fccda
