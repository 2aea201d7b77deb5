/// Interior of a closed surface, by ray crossings.
///
/// A line along x through a row of points crosses the surface where it enters and leaves the enclosed solids; the winding number is constant
/// between crossings. Each row of a lattice thus needs one traversal of the bounding volume hierarchy. Overlapping parts are united; inner
/// walls bound cavities.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/file_surface.hpp"
#include "perimpact/discretisation/frame.hpp"
#include "perimpact/discretisation/row.hpp"

namespace perimpact {

class SurfaceSolid {
 public:
  /// Throws InputError if the file cannot be read or its surface is not closed.
  SurfaceSolid(const FileSurface& setup, const Frame& frame);
  /// From panels in global coordinates. `name`: of the surface in messages.
  SurfaceSolid(const fccda::Panels& panels, double weld, const std::string& name);

  /// Sets `inside` to `mark` for the points of the row in the solid or within `margin` [m] of its surface.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const;

  /// Winding number of the point: the solid angle of all triangles over 4π (van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983)
  /// 125). Slow and robust away from the surface: fallback and test reference of mark().
  double winding(const Vec3d& point) const;

  fccda::Box bounds() const { return surface_->report().bounds; }
  /// [m³]; empty if parts may overlap.
  std::optional<double> volume() const;

 private:
  std::shared_ptr<const fccda::Surface> surface_;  // shared by copies; its address is stable for the tree
  std::shared_ptr<const fccda::Bvh> tree_;
};

}  // namespace perimpact
