/// Displacement of a surface when a vertex is removed: the triangles about it, compared with those that fill their outline.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "base/vec3.hpp"

namespace fccda {

/// The triangles (centre, link[j], link[j + 1]) about a vertex.
struct Fan {
  static constexpr std::size_t max_links = 64;  ///< larger fans are not evaluated

  Vec3d centre;                 ///< [m]
  std::span<const Vec3d> link;  ///< [m]
  bool goes_round;              ///< the last link is joined to the first; else the centre lies on the boundary

  std::size_t size() const { return goes_round ? link.size() : link.size() - 1; }  ///< triangles
};

/// [m] The largest distance between points of the fan and of the triangles (link[to], link[j], link[j + 1]) on one line along `direction`
/// (unit). Both cover the same polygon in the plane across it. If both do so exactly once, every point of one corresponds to a point of the
/// other, and the result bounds the distance in both directions. Differences of height are linear where an old triangle and a new one
/// overlap, so the largest is at the centre or where an old edge crosses a new one. Nothing if the fan or the new triangles are inclined to
/// the direction by more than 87° or overlap themselves. On a boundary the centre must lie on the straight line between the first and the
/// last link, and link[to] must be one of them.
std::optional<double> shift(const Fan& fan, std::size_t to, const Vec3d& direction);

}  // namespace fccda
