#include "perimpact/boundary_conditions/pressure/boundary.hpp"

#include <fmt/format.h>

#include <utility>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

/// The outermost particles of a lattice share the area equally, those of a point cloud by volume.
Load make_boundary(const PressureSetup& load, const BoundarySite& site) {
  const BodyFace face(load.face.index);
  const Particles& particles = site.of.particles;
  std::vector<std::uint32_t> slots = site.slots(load.particle_set);
  std::vector<double> areas;
  if (const Lattice* lattice = particles.lattice()) {
    slots = outermost(particles, slots, face);
    const double cell = lattice->spacing * particles.thickness().value_or(lattice->spacing);
    areas.assign(slots.size(), load.area ? *load.area / static_cast<double>(particles.share().ranks().sum(static_cast<std::int64_t>(slots.size()))) : cell);
  } else {
    if (!load.area)
      throw SetupError(site.key,
                       fmt::format("body {} is a point cloud without faces; give the area [m2] that the particles of the set share.", site.of.body.name));
    const double volume = exact_sum_over_eights(particles.share().ranks(), slots, [&](std::size_t k) { return particles.volume(slots[k]); });
    for (const std::uint32_t slot : slots) areas.push_back(*load.area * particles.volume(slot) / volume);
  }
  return Load(std::move(slots), std::move(areas), particles, -load.value * face.normal(), site.factor(load.times, load.factors));
}

}  // namespace perimpact
