/// What a closed surface encloses.
///
/// A line along x through a row of points crosses the surface where it goes into and out of the solids that the surface bounds; between two
/// crossings the number of solids around a point does not change. Rows of a lattice so take one walk through the tree of boxes each.
/// Overlapping parts count as united; inner walls bound hollows.
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
  /// Throws InputError, one sentence, where the file cannot be read or its surface is not closed.
  SurfaceSolid(const FileSurface& setup, const Frame& frame);
  /// Of panels in the world. `name`: how messages call the surface.
  SurfaceSolid(const fccda::Panels& panels, double weld, const std::string& name);

  /// Sets those of `inside`, one for each point of the row, that are in the solid or within `margin` [m] of its surface to `mark`.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const;

  /// How many solids hold the point: the solid angle under which it sees all triangles, over 4π (van Oosterom and Strackee, IEEE Trans.
  /// Biomed. Eng. 30 (1983) 125). Slow and never in doubt but on the surface: what mark() falls back on, and is tested against.
  double winding(const Vec3d& point) const;

  fccda::Box bounds() const { return surface_->report().bounds; }
  /// [m³]; nothing where parts may overlap.
  std::optional<double> volume() const;

 private:
  std::shared_ptr<const fccda::Surface> surface_;  // copies share it, and the tree finds it when this is moved
  std::shared_ptr<const fccda::Bvh> tree_;
};

}  // namespace perimpact
