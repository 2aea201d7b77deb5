/// What kernels read of the particles of a body.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"

namespace perimpact {

/// Arrays by slot, as in Particles.
struct ParticlesView {
  std::array<const double*, 3> position, velocity;  ///< [m] [m/s]
  const std::uint8_t* occupied;                     ///< of each eight: bit l for a particle in slot 8 n + l
  const double* volumes;                            ///< [m³] of each particle of a cloud; null on a lattice
  double cell_volume;                               ///< [m³] of each particle of a lattice

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    for (auto* vector : {&position, &velocity})
      for (const double*& component : *vector) visit(component);
    visit(occupied), visit(volumes);
  }
  FCCDA_HD bool is_occupied(std::size_t slot) const { return (occupied[slot / 8] >> (slot % 8)) & 1u; }
  FCCDA_HD double volume(std::size_t slot) const { return volumes ? volumes[slot] : cell_volume; }
};

}  // namespace perimpact
