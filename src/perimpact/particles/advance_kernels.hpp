/// Advance of packs of particles by one step.
#pragma once

#include <array>
#include <cstddef>

#include "base/host_device.hpp"
#include "base/pack.hpp"

namespace perimpact {

/// Arrays by slot, as in Particles, and the step.
struct Motion {
  std::array<double*, 3> position, velocity;  ///< [m] [m/s]
  std::array<const double*, 3> force;         ///< [N/m³]
  double kick;                                ///< [m³ s/kg] dt/ρ
  double dt;                                  ///< [s]

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    for (auto* vector : {&position, &velocity})
      for (double*& component : *vector) visit(component);
    for (const double*& component : force) visit(component);
  }
};

/// v += f dt/ρ, then x += v dt.
template <class Pack>
FCCDA_HD void advance_pack(const Motion& motion, std::size_t slot) {
  using namespace fccda;
  for (std::size_t c = 0; c < 3; ++c) {
    double *x = motion.position[c] + slot, *v = motion.velocity[c] + slot;
    const Pack velocity = fused_multiply_add(load<Pack>(motion.force[c] + slot), Pack(motion.kick), load<Pack>(v));
    store(v, velocity);
    store(x, fused_multiply_add(velocity, Pack(motion.dt), load<Pack>(x)));
  }
}

/// |v|² [m²/s²].
template <class Pack>
FCCDA_HD Pack squared_speed(const Motion& motion, std::size_t slot) {
  Pack squared(0.0);
  for (std::size_t c = 0; c < 3; ++c) {
    const Pack v = fccda::load<Pack>(motion.velocity[c] + slot);
    squared = fccda::fused_multiply_add(v, v, squared);
  }
  return squared;
}

}  // namespace perimpact
