#include "perimpact/boundary_conditions/body_force/boundary.hpp"

#include <utility>

namespace perimpact {

Load make_boundary(const BodyForceSetup& load, const BoundarySite& site) {
  std::vector<std::uint32_t> slots = site.slots(load.particle_set);
  std::vector<double> volumes;
  for (const std::uint32_t slot : slots) volumes.push_back(site.of.particles.volume(slot));
  return Load(std::move(slots), std::move(volumes), site.of.particles, load.force_density, site.factor(load.times, load.factors));
}

}  // namespace perimpact
