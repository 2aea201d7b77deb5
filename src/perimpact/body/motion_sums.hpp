/// Momentum and kinetic energy of a body: sums over its particles.
#pragma once

#include "base/host_device.hpp"
#include "base/vec3.hpp"

namespace perimpact {

/// Of one particle, of an eight, or of a body.
struct MotionSums {
  fccda::Vec3d momentum{};              ///< [kg m/s] with the velocities of mid-step
  double kinetic_energy = 0;            ///< [J] with velocities advanced from the middle of the step to its end by the current forces: v + f dt/(2ρ)
  double kinetic_energy_of_scheme = 0;  ///< [J] ½ Σ m v_{n-1/2}·v_{n+1/2}: its sum with the elastic energy of linear bonds is constant to rounding, while that
                                        ///< of kinetic_energy oscillates by (ω dt)² (docs/theory/energy.md)
  double kinetic_energy_amid_step = 0;  ///< [J] with the velocities of mid-step

  constexpr MotionSums& operator+=(const MotionSums& other) {
    momentum += other.momentum;
    kinetic_energy += other.kinetic_energy;
    kinetic_energy_of_scheme += other.kinetic_energy_of_scheme;
    kinetic_energy_amid_step += other.kinetic_energy_amid_step;
    return *this;
  }
};

/// Of a particle with this mass [kg], velocity in the middle of the step [m/s] and change of velocity [m/s] by the current forces in a step.
FCCDA_HD inline MotionSums motion_of(double mass, const fccda::Vec3d& velocity, const fccda::Vec3d& change) {
  return {mass * velocity, 0.5 * mass * fccda::squared_norm(velocity + 0.5 * change), 0.5 * mass * dot(velocity, velocity + change),
          0.5 * mass * fccda::squared_norm(velocity)};
}

}  // namespace perimpact
