#include "perimpact/particles/advance.hpp"

#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace perimpact {

using namespace fccda;

Motion motion_of(Particles& particles, double dt) {
  return {particles.position.writable_pointers(), particles.velocity.writable_pointers(), std::as_const(particles.force_density).pointers(),
          dt / particles.density(), dt};
}

void advance(Particles& particles, double dt, std::span<double> travel) {
  EXPECTS(travel.size() == travel_blocks(particles));
  using Pack = NativePack;
  const Motion motion = motion_of(particles, dt);
  const std::size_t slots = particles.slots();
  parallel_for(static_cast<std::ptrdiff_t>(travel.size()), [&](std::ptrdiff_t block) {
    const std::size_t begin = static_cast<std::size_t>(block) * travel_block, end = std::min(begin + travel_block, slots);
    Pack fastest(0.0);
    for (std::size_t slot = begin; slot < end; slot += lanes<Pack>) {
      advance_pack<Pack>(motion, slot);
      fastest = larger(squared_speed<Pack>(motion, slot), fastest);
    }
    double values[lanes<Pack>];
    store(values, fastest);
    double largest = 0;
    for (const double value : values) largest = larger(value, largest);
    travel[static_cast<std::size_t>(block)] = std::sqrt(largest) * dt;
  });
}

}  // namespace perimpact
