/// Inside and outside of a closed surface with overlapping parts: blades embedded in a hub, a bow thruster in a hull. Points of one part
/// inside another do not belong to the surface; the surface is that of the union.
///
/// For a point p, let q be the closest point over all triangles, on the triangle t of the solid A. The pseudonormal at q determines whether p
/// is inside A, since q is also A's closest point. If it is outside A, p could still be inside another solid B. This is impossible if all of
/// t is outside B: the segment from p to q would leave B before q, through a triangle nearer than q. So the sign is correct wherever t is
/// certainly outside the other solids. The remaining triangles (buried, intersected by another solid, or closer to one than their own width)
/// are determined at construction. Only if one of those is closest, every solid is queried separately.
///
/// The distance needs no such treatment: seen from outside, a nearer triangle lies in front of any buried one.
///
/// Immutable after construction, so any number of threads may query it concurrently.
/// Nothing changes after construction, so any number of threads may ask at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// The solids of a surface, each with its own search structure where they may overlap.
class Solids {
 public:
  /// None: of a surface whose parts do not overlap.
  Solids() = default;

  /// `surface` must outlive the object. For one solid, or an open surface, nothing is built.
  explicit Solids(const Surface& surface);

  bool several() const { return !solids_.empty(); }  ///< the surface has more than one solid

  /// The triangle may lie in another solid, fully or partly.
  bool may_be_buried(int triangle) const { return several() && buried_[static_cast<std::size_t>(triangle)] != 0; }
  std::size_t buried_count() const;  ///< number of triangles that may be buried

  /// True if the point is inside a solid other than that of the triangle.
  bool another_holds(int triangle, const Vec3d& point, std::size_t& tested) const;

  /// The solid that a point is deepest in or, if it is in none, nearest to.
  struct Nearest {
    ClosestPoint closest;    ///< of that solid
    double signed_distance;  ///< [m] negative inside
  };
  /// Expects several solids. Nothing for a point that is not a number.
  std::optional<Nearest> nearest(const Vec3d& point, std::size_t& tested) const;

  /// The closest point of one solid among the triangles whose front faces `viewer`.
  std::optional<ClosestPoint> closest_facing(int solid, const Vec3d& point, const Vec3d& viewer, double cap, std::size_t& tested) const;

 private:
  struct Solid {
    Bvh bvh;
    Box bounds;
  };

  bool contains(const Solid& solid, const Vec3d& point, std::size_t& tested) const;
  bool is_surely_outside(const Solid& solid, std::size_t triangle) const;

  const Surface* surface_ = nullptr;
  std::vector<Solid> solids_;
  std::vector<std::uint8_t> buried_;  // by triangle
};

}  // namespace fccda
