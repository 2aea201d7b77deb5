#include "perimpact/boundary_conditions/floating/boundary.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

Floating make_boundary(const FloatingSetup& floating, const BoundarySite& site) {
  const Particles& particles = site.of.particles;
  std::vector<std::uint32_t> slots = site.slots(floating.particle_set);
  Water water{.level = floating.level.value_or(0),
              .density = floating.density,
              .gravity = floating.gravity,
              .drag = floating.drag,
              .added_mass = floating.added_mass,
              .damping = floating.damping};
  const std::optional<double> floats_at = floating_level(particles, slots, water);
  if (!floating.level) {
    if (!floats_at)
      throw SetupError(site.key,
                       fmt::format("body {} of {} kg/m3 sinks in water of {} kg/m3, so that it has no equilibrium level; give the level, or correct a density.",
                                   site.of.body.name, particles.density(), floating.density));
    water.level = *floats_at;
  }
  return Floating(std::move(slots), water, floats_at.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace perimpact
