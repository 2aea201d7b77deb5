/// Solid in global coordinates, with an inside test: shape, added solid, hole or particle set of a body.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "base/vec3.hpp"
#include "perimpact/deck_model/solids.hpp"
#include "perimpact/discretisation/frame.hpp"
#include "perimpact/discretisation/row.hpp"
#include "perimpact/discretisation/surface_solid.hpp"

namespace perimpact {

/// Promises (tests/perimpact/discretisation/solid.test.cpp, over all shapes):
///  1. points on the surface are inside, as are points outside by at most the margin;
///  2. the result for a row equals that for its points;
///  3. objects are immutable, so that queries are thread-safe.
class Solid {
 public:
  /// Throws InputError for an invalid file.
  Solid(const SolidShape& shape, const Frame& frame);

  bool contains(const Vec3d& point, double margin = 0) const;

  /// Sets `inside` to `mark` for the points of the row for which contains() is true.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const;

  const fccda::Box& bounds() const { return bounds_; }             ///< [m] in global axes
  const std::optional<double>& volume() const { return volume_; }  ///< [m³] if known

 private:
  Frame frame_;
  std::variant<BoxSolid, CylinderSolid, SphereSolid, SurfaceSolid> shape_;  // the surface in global coordinates, the others in local axes
  fccda::Box bounds_;
  std::optional<double> volume_;
};

}  // namespace perimpact
