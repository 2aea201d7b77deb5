/// A solid somewhere in the world: what is filled with particles, taken out, or named.
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
///  1. what is on its surface is inside, and so is what is outside by no more than the margin that is asked for;
///  2. a row is answered as its points are one by one;
///  3. nothing changes after construction, so any number of threads may ask at once.
class Solid {
 public:
  /// Throws InputError, one sentence, where a file cannot be used.
  Solid(const SolidShape& shape, const Frame& frame);

  bool contains(const Vec3d& point, double margin = 0) const;

  /// Sets those of `inside`, one for each point of the row, that contains() holds to `mark`.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const;

  const fccda::Box& bounds() const { return bounds_; }             ///< [m] along the axes of the world
  const std::optional<double>& volume() const { return volume_; }  ///< [m³] where it is known

 private:
  Frame frame_;
  std::variant<BoxSolid, CylinderSolid, SphereSolid, SurfaceSolid> shape_;  // the surface in the world, the others along their own axes
  fccda::Box bounds_;
  std::optional<double> volume_;
};

}  // namespace perimpact
