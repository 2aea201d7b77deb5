#include "perimpact/boundary_conditions/floating/floating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perimpact {

namespace {

struct Hydrostatics {
  ForceSum forces{};
  double potential = 0;  // [J]
  Hydrostatics& operator+=(const Hydrostatics& other) {
    forces += other.forces, potential += other.potential;
    return *this;
  }
};

}  // namespace

std::optional<double> floating_level(const Particles& particles, std::span<const std::uint32_t> slots, const Water& water) {
  double low = std::numeric_limits<double>::infinity(), high = -low, mass = 0, volume = 0;
  for (const std::uint32_t slot : slots) {
    const double z = particles.position.at(slot).z, half = 0.5 * particles.size_of(slot);
    low = std::min(low, z - half), high = std::max(high, z + half);
    mass += particles.mass(slot), volume += particles.volume(slot);
  }
  if (mass > water.density * volume) return std::nullopt;
  Water trial = water;
  for (int halvings = 0; halvings < 100 && high - low > 1e-15 * (std::fabs(high) + std::fabs(low)); ++halvings) {
    trial.level = 0.5 * (low + high);
    double displaced = 0;
    for (const std::uint32_t slot : slots) displaced += particles.volume(slot) * trial.submerged(particles.position.at(slot).z, particles.size_of(slot));
    (water.density * displaced < mass ? low : high) = trial.level;
  }
  return 0.5 * (low + high);
}

Floating::Floating(std::vector<std::uint32_t> slots, const Water& water, double floats_at)
    : slots_(std::move(slots)), moves_(slots_.size(), {true, true, true}), water_(water), floats_at_(floats_at), forces_(resists() ? slots_.size() : 0) {}

void Floating::leave_out(std::span<const std::uint32_t> held, std::size_t axis) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (std::binary_search(held.begin(), held.end(), slots_[k])) moves_[k][axis] = false;
}

void Floating::update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends) {
  if (water_.drag == 0) return;
  if (exposure_)
    exposure_->update(particles, family, broken_ends);
  else
    exposure_.emplace(particles, family, broken_ends);
}

ForceSum Floating::static_hydrostatics(Particles& particles) {
  const double weight = particles.density() * water_.gravity, lift = water_.density * water_.gravity;  // [N/m³]
  const Hydrostatics sum = sum_in_blocks<Hydrostatics>(slots_.size(), [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const double z = particles.position.at(slot).z, height = particles.size_of(slot), volume = particles.volume(slot);
    const double t = (water_.level - z) / height + 0.5;
    const double column = t <= 0 ? 0 : t < 1 ? 0.5 * t * t : t - 0.5;  // ∫ S dz/Δ from the particle upward
    Vec3d density = particles.force_density.at(slot);
    const double net = lift * water_.submerged(z, height) - weight;
    density.z += net;
    particles.force_density.set(slot, density);
    const double force = volume * net;
    return Hydrostatics{{{0, 0, force}, force * force}, volume * (weight * z + lift * height * column)};
  });
  if (has_begun_) {
    account.add({}, potential_ - sum.potential);
    weight_buoyancy_work_ += potential_ - sum.potential;
  }
  potential_ = sum.potential, has_begun_ = true;
  return sum.forces;
}

Vec3d Floating::resist(Particles& particles, double dt) {
  if (!resists()) return {};
  const double density = particles.density();
  const Resistance sum = sum_in_blocks<Resistance>(slots_.size(), [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const Vec3d velocity = particles.velocity.at(slot);
    const bool is_exposed = exposure_ && exposure_->is_exposed(slot);
    if (!is_exposed && water_.damping == 0 && water_.added_mass == 0) return forces_.record_force(k, {}, dt * velocity);  // most particles of a thick body
    const Vec3d before = particles.force_density.at(slot);
    const double height = particles.size_of(slot), wet = water_.submerged(particles.position.at(slot).z, height);
    const bool drags = wet > 0 && is_exposed;
    const double damping =
        water_.damping + (drags ? 0.5 * water_.density * water_.drag * height * height * wet * norm(velocity) / (density * particles.volume(slot)) : 0);
    Vec3d after = before;
    for (std::size_t c = 0; c < 3; ++c)
      if (moves_[k][c]) after[c] = damped(before[c], velocity[c], density, damping, dt);
    if (moves_[k][2]) after.z *= density / (density + water_.added_mass * water_.density * wet);
    particles.force_density.set(slot, after);
    return forces_.record_force(k, particles.volume(slot) * (after - before), dt * velocity);
  });
  account.add({}, sum.work);
  drag_work_ += sum.work;
  return sum.force;
}

}  // namespace perimpact
