#include "perimpact/boundary/absorbing.hpp"

#include <algorithm>
#include <cmath>

#include "fccda/core/contract.hpp"
#include "perimpact/boundary/slot_sum.hpp"

namespace perimpact {

double layer_damping(double depth, double thickness, double wave_speed, double reflection) {
  const double share = depth / thickness;
  return 3 * wave_speed * std::log(1 / reflection) / thickness * share * share;
}

Absorbing::Absorbing(std::vector<std::uint32_t> slots, std::vector<double> damping) : slots_(std::move(slots)), damping_(std::move(damping)) {
  EXPECTS(slots_.size() == damping_.size());
}

void Absorbing::leave_out(std::span<const std::uint32_t> slots) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (std::binary_search(slots.begin(), slots.end(), slots_[k])) continue;
    slots_[kept] = slots_[k], damping_[kept] = damping_[k];
    ++kept;
  }
  slots_.resize(kept), damping_.resize(kept);
}

namespace {

struct Damped {
  Vec3d force{};     // [N]
  double power = 0;  // [W]
  Damped& operator+=(const Damped& other) {
    force += other.force, power += other.power;
    return *this;
  }
};

}  // namespace

void Absorbing::damp(Particles& particles, double dt) {
  const double density = particles.density();
  const Damped sum = sum_in_blocks<Damped>(slots_.size(), [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const Vec3d before = particles.force_density.at(slot), velocity = particles.velocity.at(slot);
    const Vec3d after = (before - density * damping_[k] * velocity) / (1 + 0.5 * damping_[k] * dt);
    particles.force_density.set(slot, after);
    const Vec3d force = particles.volume() * (after - before);
    return Damped{force, dot(force, velocity + 0.5 * dt / density * after)};
  });
  account.note(sum.force, {});
  account.add({}, 0.5 * dt * (power_ + sum.power));
  power_ = sum.power;
}

}  // namespace perimpact
