#include "perimpact/boundary_conditions/absorbing/absorbing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contract.hpp"

namespace perimpact {

double layer_damping(double depth, double thickness, double wave_speed, double reflection) {
  const double share = depth / thickness;
  return 3 * wave_speed * std::log(1 / reflection) / thickness * share * share;
}

Absorbing::Absorbing(std::vector<std::uint32_t> slots, std::span<const double> damping) : slots_(std::move(slots)), eights_(slots_), forces_(eights_.places()) {
  EXPECTS(slots_.size() == damping.size());
  for (std::vector<double>& along : damping_) {
    along.assign(eights_.places(), 0.0);
    for (std::size_t k = 0; k < slots_.size(); ++k) along[eights_.place(k)] = damping[k];
  }
}

void Absorbing::leave_out(std::span<const std::uint32_t> constrained, std::size_t axis) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (std::binary_search(constrained.begin(), constrained.end(), slots_[k])) damping_[axis][eights_.place(k)] = 0;
}

Vec3d Absorbing::damping(std::size_t k) const {
  const std::size_t place = eights_.place(k);
  return {damping_[0][place], damping_[1][place], damping_[2][place]};
}

AbsorbingView Absorbing::view(Particles& particles, double dt) {
  return {particles.view(),
          eights_.view(),
          particles.force_density.writable_pointers(),
          {damping_[0].data(), damping_[1].data(), damping_[2].data()},
          forces_.view(),
          particles.density(),
          dt};
}

void Absorbing::damp(Particles& particles, double dt) {
  using Pack = fccda::NativePack;
  const AbsorbingView layer = view(particles, dt);
  record(exact_sum_of_eights(particles.share().ranks(), eights_.count(), [&](std::size_t eight) {
    return resistance_of_eight<Pack>(eight, [&](std::size_t place) { return damp_pack<Pack>(layer, place); });
  }));
}

void Absorbing::record(const Resistance& sum) {
  account.record_force(sum.force, {});
  account.add({}, sum.work);
}

}  // namespace perimpact
