/// What loads and prescribed displacements do to one particle, on the host and in kernels.
#pragma once

#include <array>
#include <cstddef>

#include "base/host_device.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// The force density [N/m³] of a particle with that weight under the load q f(t), from that of all other forces.
FCCDA_HD inline Vec3d with_load(const Vec3d& density, double weight, double volume, const Vec3d& load) { return density + weight / volume * load; }

/// What a prescribed displacement imposes on each of its particles in a step.
struct PrescribedMotion {
  std::array<bool, 3> constrains;  ///< along x, y, z
  Vec3d displacement, velocity;    ///< [m] at the end, [m/s]; of these directions

  /// Sets position and velocity of the particle in a slot, from its reference position [m].
  FCCDA_HD void impose(std::size_t slot, const Vec3d& reference, const std::array<double*, 3>& positions, const std::array<double*, 3>& velocities) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (constrains[c]) positions[c][slot] = reference[c] + displacement[c], velocities[c][slot] = velocity[c];
  }
  /// [N/m³] force density that leads to that velocity, from the current one; `scale`: ρ/dt.
  FCCDA_HD double force_density(double scale, std::size_t axis, double current) const { return scale * (velocity[axis] - current); }
};

}  // namespace perimpact
