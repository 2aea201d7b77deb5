#include "io/results/frame_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/family/exposure.hpp"

namespace perimpact {

namespace {

bool is_in_a_box(const FrameParticlesSetup& setup, const Vec3d& reference) {
  return setup.boxes.empty() || std::any_of(setup.boxes.begin(), setup.boxes.end(), [&](const FrameBoxSetup& box) { return box.contains(reference); });
}

/// One of n particles in each direction: by the cells of a lattice, in a point cloud by the order of its particles.
bool is_on_stride(const Particles& particles, std::size_t particle, std::size_t slot, int n) {
  if (const Lattice* lattice = particles.whole_lattice()) {
    const auto [i, j, k] = lattice->cell(particles.share().whole_slot(slot));
    return i % n == 0 && j % n == 0 && k % n == 0;
  }
  const auto one = static_cast<std::size_t>(n);
  return particle % (particles.is_plane() ? one * one : one * one * one) == 0;
}

bool is_always_written(const FrameParticlesSetup& setup, const Particles& particles, std::size_t particle) {
  const std::size_t slot = particles.slot_of()[particle];
  return !setup.has_criterion() || (setup.surface && is_at_surface(particles, slot)) ||
         (setup.stride && is_on_stride(particles, particle, slot, *setup.stride));
}

bool has_particle_in(const FrameBoxSetup& box, const Simulation& simulation) {
  return simulation.ranks().any(std::any_of(simulation.bodies().begin(), simulation.bodies().end(), [&](const Body& body) {
    const auto slots = body.particles.slot_of();
    return std::any_of(slots.begin(), slots.end(), [&](std::uint32_t slot) { return box.contains(body.particles.reference(slot)); });
  }));
}

}  // namespace

FrameParticles::FrameParticles(const std::optional<FrameParticlesSetup>& setup, const Body& body)
    : is_thinned_(setup.has_value()),
      varies_(setup && setup->varies()),
      damage_above_(setup ? setup->damage_above : std::nullopt),
      detached_(setup && setup->detached) {
  if (!is_thinned_) return;
  const Particles& particles = body.particles;
  for (std::size_t particle = 0; particle < particles.size(); ++particle) {
    if (!is_in_a_box(*setup, particles.reference(particles.slot_of()[particle]))) continue;
    const bool is_written = is_always_written(*setup, particles, particle);
    if (is_written || varies_) (is_written ? always_ : candidates_).push_back(static_cast<std::int32_t>(particle));
  }
}

ParticleNumbers FrameParticles::now(const Body& body, const Fragments* fragments) const {
  if (!is_thinned_) return {};
  if (!varies_) return always_;
  std::vector<std::int32_t> added, numbers;
  for (const std::int32_t number : candidates_) {
    const auto particle = static_cast<std::size_t>(number);
    if ((damage_above_ && body.family.damage(body.particles.slot_of()[particle]) > *damage_above_) ||
        (detached_ && fragments && fragments->of_particles()[particle] > 0))
      added.push_back(number);
  }
  std::merge(always_.begin(), always_.end(), added.begin(), added.end(), std::back_inserter(numbers));
  return numbers;
}

std::vector<FrameParticles> frame_particles_of(const Simulation& simulation) {
  const auto& setup = simulation.setup().output.frame_particles;
  std::vector<FrameParticles> particles;
  if (setup) {
    for (const FrameBoxSetup& box : setup->boxes)
      if (!has_particle_in(box, simulation))
        throw SetupError("output.frame_particles.boxes." + box.name,
                         fmt::format("box {} contains no particle of any body in the reference configuration; move or enlarge it, or remove it.", box.name));
  }
  for (const Body& body : simulation.bodies()) particles.emplace_back(setup, body);
  return particles;
}

}  // namespace perimpact
