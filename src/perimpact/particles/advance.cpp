#include "perimpact/particles/advance.hpp"

#include <cmath>

#include "base/parallel.hpp"

namespace perimpact {

using namespace fccda;

void advance(Particles& particles, double dt, std::span<double> travel) {
  EXPECTS(travel.size() == travel_blocks(particles));
  using Pack = NativePack;
  const Pack kick(dt / particles.density()), drift(dt);
  const std::size_t slots = particles.slots();
  parallel_for(static_cast<std::ptrdiff_t>(travel.size()), [&](std::ptrdiff_t block) {
    const std::size_t begin = static_cast<std::size_t>(block) * travel_block, end = std::min(begin + travel_block, slots);
    Pack fastest(0.0);
    for (std::size_t slot = begin; slot < end; slot += lanes<Pack>) {
      Pack squared(0.0);
      for (std::size_t c = 0; c < 3; ++c) {
        double* x = particles.position.component(c) + slot;
        double* v = particles.velocity.component(c) + slot;
        const Pack velocity = fused_multiply_add(load<Pack>(particles.force_density.component(c) + slot), kick, load<Pack>(v));
        store(v, velocity);
        store(x, fused_multiply_add(velocity, drift, load<Pack>(x)));
        squared = fused_multiply_add(velocity, velocity, squared);
      }
      fastest = larger(squared, fastest);
    }
    double values[lanes<Pack>];
    store(values, fastest);
    double largest = 0;
    for (const double value : values) largest = larger(value, largest);
    travel[static_cast<std::size_t>(block)] = std::sqrt(largest) * dt;
  });
}

}  // namespace perimpact
