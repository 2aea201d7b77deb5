#include "perimpact/boundary_conditions/actions/load.hpp"

#include "base/contract.hpp"
#include "base/parallel.hpp"

namespace perimpact {

Load::Load(std::vector<std::uint32_t> slots, std::vector<double> weights, const Particles& particles, const Vec3d& intensity, fccda::PiecewiseLinear factor)
    : slots_(std::move(slots)),
      weights_(std::move(weights)),
      total_weight_(exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) { return weights_[k]; })),
      squared_weights_(exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) { return weights_[k] * weights_[k]; })),
      weights_by_mass_(
          exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) { return weights_[k] * weights_[k] / particles.mass(slots_[k]); })),
      intensity_(intensity),
      factor_(std::move(factor)) {
  EXPECTS(slots_.size() == weights_.size());
}

ForceSum Load::static_load(Particles& particles, double time) const {
  const Vec3d now = intensity(time);
  fccda::parallel_for_blocks(slots_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t slot = slots_[k];
      particles.force_density.set(slot, with_load(particles.force_density.at(slot), weights_[k], particles.volume(slot), now));
    }
  });
  return {total_weight_ * now, squared_weights_ * squared_norm(now)};
}

double Load::half_kick(double time, double dt) const { return 0.125 * dt * dt * weights_by_mass_ * squared_norm(intensity(time)); }

Vec3d Load::weighted_displacement(const Particles& particles) const {
  return exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) { return weights_[k] * particles.displacement(slots_[k]); });
}

}  // namespace perimpact
