#include "perimpact/impactor/in_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/impactor/may_move.hpp"

namespace perimpact {

namespace {

/// The first out-of-plane degree of freedom in which it may move.
std::optional<std::string_view> way_out_of_plane(const ImpactorSetup& setup, const Impactor& impactor) {
  for (const std::size_t degree : {2u, 3u, 4u})
    if (may_move(setup, impactor, degree)) return degree_words[degree];
  return std::nullopt;
}

}  // namespace

void expect_in_plane(const ImpactorSetup& setup, const Impactor& impactor, const Particles& particles, double reach) {
  const std::string key = "impactors." + setup.name;
  if (const auto degree = way_out_of_plane(setup, impactor))
    throw SetupError(
        key, fmt::format("{} moves or is free in {}, but a body that it may contact is plane: restrict it to motion along x and y and rotation about z.",
                         setup.name, *degree));
  if (particles.slots() == 0) return;
  constexpr double upright = 1e-6;  // of a unit normal along z: vertices rounded to single precision
  const double plane = particles.position.at(0).z;
  const fccda::Surface& surface = impactor.surface();
  const fccda::Pose& pose = impactor.body().pose();
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d corners[] = {pose.to_world(surface.corner(t, 0)), pose.to_world(surface.corner(t, 1)), pose.to_world(surface.corner(t, 2))};
    const auto [low, high] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    if (low > plane + reach || high < plane - reach) continue;
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec3d &a = corners[e], &b = corners[(e + 1) % 3];
      const bool is_near = std::min(a.z, b.z) < plane + reach && std::max(a.z, b.z) > plane - reach;
      if (!is_near || surface.neighbour(t, e) >= 0 || std::fabs(b.z - a.z) >= (1 - upright) * norm(b - a)) continue;
      throw SetupError(key + ".surface",
                       fmt::format("a body that {} may contact is plane, at z = {:.6g} m, but the surface ends near there: at ({:.4g}, {:.4g}, {:.4g}) m. A "
                                   "plane body extends along z; let the surface reach from {:.3g} m below the plane to as much above it.",
                                   setup.name, plane, a.x, a.y, a.z, reach));
    }
    const double lean = std::fabs(pose.turn_to_world(surface.normal(t)).z);
    if (lean <= upright) continue;
    const Vec3d at = (corners[0] + corners[1] + corners[2]) / 3;
    throw SetupError(key + ".surface", fmt::format("a body that {} may contact is plane, at z = {:.6g} m, but the surface does not run along z where it meets "
                                                   "it: a panel at ({:.4g}, {:.4g}, {:.4g}) m is inclined by {:.3g} degrees. A plane body extends along z; use "
                                                   "a prismatic surface, such as a cylinder with axis z, from {:.3g} m below the plane to as much above it.",
                                                   setup.name, plane, at.x, at.y, at.z, std::asin(std::min(lean, 1.0)) * 180 / std::numbers::pi, reach));
  }
}

}  // namespace perimpact
