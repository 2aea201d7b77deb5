#include "mesh/search/solids.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace fccda {

namespace {

double sign_of(const Surface& surface, const ClosestPoint& closest, const Vec3d& point) {
  return dot(point - closest.point, surface.pseudonormal(static_cast<std::size_t>(closest.triangle), closest.feature)) < 0 ? -1 : 1;
}

}  // namespace

Solids::Solids(const Surface& surface) : surface_(&surface) {
  if (!surface.is_closed() || surface.solids() < 2) return;
  std::vector<std::vector<std::int32_t>> members(surface.solids());
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) members[static_cast<std::size_t>(surface.solid_of(t))].push_back(static_cast<std::int32_t>(t));
  for (const std::vector<std::int32_t>& triangles : members) {
    Box bounds;
    for (const std::int32_t t : triangles)
      for (std::size_t c = 0; c < 3; ++c) bounds.include(surface.corner(static_cast<std::size_t>(t), c));
    solids_.push_back({Bvh(surface, triangles), bounds});
  }
  buried_.assign(surface.triangles().size(), 0);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(buried_.size()), [&](std::ptrdiff_t k) {
    const auto t = static_cast<std::size_t>(k);
    for (std::size_t s = 0; s < solids_.size(); ++s)
      if (static_cast<int>(s) != surface.solid_of(t) && !is_surely_outside(solids_[s], t)) buried_[t] = 1;
  });
}

// The bounding sphere about a triangle's centroid intersects no triangle of the other solid, so the whole triangle is on one side.
bool Solids::is_surely_outside(const Solid& solid, std::size_t triangle) const {
  const Vec3d &a = surface_->corner(triangle, 0), &b = surface_->corner(triangle, 1), &c = surface_->corner(triangle, 2);
  const Vec3d middle = (a + b + c) / 3.0;
  // Rounding must not separate two that just touch.
  const double radius = std::sqrt(std::max({squared_norm(a - middle), squared_norm(b - middle), squared_norm(c - middle)})) +
                        1e-9 * largest_magnitude(surface_->report().bounds.size());
  if (solid.bounds.distance(middle) > radius) return true;
  if (solid.bvh.closest(middle, radius)) return false;
  std::size_t tested = 0;
  return !contains(solid, middle, tested);
}

std::size_t Solids::buried_count() const { return static_cast<std::size_t>(std::count(buried_.begin(), buried_.end(), 1)); }

bool Solids::contains(const Solid& solid, const Vec3d& point, std::size_t& tested) const {
  if (solid.bounds.distance(point) > 0) return false;
  const std::optional<ClosestPoint> closest = solid.bvh.closest(point, Bvh::no_cap, -1, tested);
  return closest && sign_of(*surface_, *closest, point) < 0;
}

bool Solids::another_holds(int triangle, const Vec3d& point, std::size_t& tested) const {
  const int own = surface_->solid_of(static_cast<std::size_t>(triangle));
  for (std::size_t s = 0; s < solids_.size(); ++s)
    if (static_cast<int>(s) != own && contains(solids_[s], point, tested)) return true;
  return false;
}

std::optional<Solids::Nearest> Solids::nearest(const Vec3d& point, std::size_t& tested) const {
  std::optional<Nearest> best;
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    if (best && solids_[s].bounds.distance(point) > std::max(0.0, best->signed_distance)) continue;
    const std::optional<ClosestPoint> closest = solids_[s].bvh.closest(point, Bvh::no_cap, -1, tested);
    if (!closest) continue;
    const double signed_distance = sign_of(*surface_, *closest, point) * closest->distance;
    if (!best || signed_distance < best->signed_distance) best = Nearest{*closest, signed_distance};
  }
  return best;
}

std::optional<ClosestPoint> Solids::closest_facing(int solid, const Vec3d& point, const Vec3d& viewer, double cap, std::size_t& tested) const {
  return solids_[static_cast<std::size_t>(solid)].bvh.closest_facing(point, viewer, cap, tested);
}

}  // namespace fccda
