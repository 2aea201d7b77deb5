/// How far a surface moves where a vertex is taken out of it: the triangles about the vertex, against those that fill their outline anew.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "base/vec3.hpp"

namespace fccda {

/// The triangles (centre, link[j], link[j + 1]) about a vertex.
struct Fan {
  static constexpr std::size_t max_links = 64;  ///< more are not looked at

  Vec3d centre;                 ///< [m]
  std::span<const Vec3d> link;  ///< [m]
  bool goes_round;              ///< the last link is joined to the first; else the centre lies on a rim

  std::size_t size() const { return goes_round ? link.size() : link.size() - 1; }  ///< triangles
};

/// [m] The largest distance between points of the fan and of the triangles (link[to], link[j], link[j + 1]) that lie on one line along
/// `direction` (unit). Both cover the same polygon in the plane across it; where they both do so once, each point of one has so a point of
/// the other, and both surfaces lie that near to each other in both directions. Differences of height are linear where an old triangle
/// and a new one overlap, so the largest is at the centre or where an old edge crosses a new one. Nothing where the fan or the new
/// triangles are turned away from the direction (to more than 87°) or overlap themselves. On a rim the centre must lie on the straight
/// line between the first and the last link, and one of them be link[to].
std::optional<double> shift(const Fan& fan, std::size_t to, const Vec3d& direction);

}  // namespace fccda
