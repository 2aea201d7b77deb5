/// Inside and outside of a closed surface whose parts overlap: blades sunk in a hub, a bow thruster in a hull. A point of one part inside
/// another is not surface; the surface is that of the union.
///
/// Of a point p, let q be the closest point of all triangles, on the triangle t of the solid A. The pseudonormal at q tells whether p is
/// inside A, for q is A's closest point too. Should it be outside A, p could still be inside another solid B. Not so where all of t is
/// outside B: the way from p to q would leave B before q, through a triangle nearer than q. So the sign is right wherever t is surely
/// outside the other solids; the rest of the triangles, buried or cut by another solid or nearer to one than they are wide, are known from
/// the start, and only where one of those is closest every solid is asked for itself.
///
/// The distance needs no such care: seen from outside, something nearer lies before whatever is buried.
///
/// Nothing changes after construction, so any number of threads may ask at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

class Solids {
 public:
  /// `surface` must outlive it. Of one solid, or an open surface, nothing is built.
  explicit Solids(const Surface& surface);

  bool several() const { return !solids_.empty(); }

  /// The triangle may lie in another solid, wholly or in part.
  bool may_be_buried(int triangle) const { return several() && buried_[static_cast<std::size_t>(triangle)] != 0; }
  std::size_t buried_count() const;

  /// Inside a solid other than that of the triangle.
  bool another_holds(int triangle, const Vec3d& point, std::size_t& asked) const;

  /// What the solids make of a point: the one it is deepest in or, where it is in none, nearest to.
  struct Nearest {
    ClosestPoint closest;
    double signed_distance;  ///< [m] negative inside
  };
  /// Where there are several. Finds nothing for a point that is no number.
  std::optional<Nearest> nearest(const Vec3d& point, std::size_t& asked) const;

  /// The closest point of one solid among the triangles whose front faces `viewer`.
  std::optional<ClosestPoint> closest_facing(int solid, const Vec3d& point, const Vec3d& viewer, double cap, std::size_t& asked) const;

 private:
  struct Solid {
    Bvh bvh;
    Box bounds;
  };

  bool holds(const Solid& solid, const Vec3d& point, std::size_t& asked) const;
  bool is_surely_outside(const Solid& solid, std::size_t triangle) const;

  const Surface* surface_;
  std::vector<Solid> solids_;
  std::vector<std::uint8_t> buried_;  // of each triangle
};

}  // namespace fccda
