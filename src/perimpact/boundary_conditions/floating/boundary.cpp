#include "perimpact/boundary_conditions/floating/boundary.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
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
              .damping = floating.damping,
              .entrained_depth = floating.entrained_depth,
              .dry_top = floating.dry_top};
  const bool needs_columns = water.entrained_depth != 0 || water.dry_top != 0;
  if (needs_columns && !particles.lattice())
    throw SetupError(site.key, fmt::format("{} belongs to the columns of a lattice, but the particles of body {} are those of a file; {}.",
                                           water.entrained_depth != 0 ? "entrained_depth" : "dry_top", site.of.body.name,
                                           water.entrained_depth != 0 ? "give added_mass" : "remove it"));
  const std::optional<double> floats_at = floating_level(particles, slots, water);
  if (!floating.level) {
    if (!floats_at)
      throw SetupError(site.key,
                       fmt::format("body {} of {} kg/m3 sinks in water of {} kg/m3, so that it has no equilibrium level; give the level, or correct a density.",
                                   site.of.body.name, particles.material_density(), floating.density));
    water.level = *floats_at;
  }
  return Floating(particles, std::move(slots), water, floats_at.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace perimpact
