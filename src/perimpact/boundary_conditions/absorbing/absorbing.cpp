#include "perimpact/boundary_conditions/absorbing/absorbing.hpp"

#include <algorithm>
#include <cmath>

#include "base/contract.hpp"

namespace perimpact {

double layer_damping(double depth, double thickness, double wave_speed, double reflection) {
  const double share = depth / thickness;
  return 3 * wave_speed * std::log(1 / reflection) / thickness * share * share;
}

Absorbing::Absorbing(std::vector<std::uint32_t> slots, std::span<const double> damping) : slots_(std::move(slots)), forces_(slots_.size()) {
  EXPECTS(slots_.size() == damping.size());
  for (const double each : damping) damping_.push_back({each, each, each});
}

void Absorbing::leave_out(std::span<const std::uint32_t> constrained, std::size_t axis) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (std::binary_search(constrained.begin(), constrained.end(), slots_[k])) damping_[k][axis] = 0;
}

void Absorbing::damp(Particles& particles, double dt) {
  const double density = particles.density();
  const Resistance sum = exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const Vec3d before = particles.force_density.at(slot), velocity = particles.velocity.at(slot);
    Vec3d after{};
    for (std::size_t c = 0; c < 3; ++c) after[c] = damped(before[c], velocity[c], density, damping_[k][c], dt);
    particles.force_density.set(slot, after);
    return forces_.record_force(k, particles.volume(slot) * (after - before), dt * velocity);
  });
  account.record_force(sum.force, {});
  account.add({}, sum.work);
}

}  // namespace perimpact
