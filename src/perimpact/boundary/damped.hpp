/// Damping that is implicit in the velocity, and what it does to the particles it acts on: for the boundaries `absorbing` and `floating`.
///
///   v_{n+1/2} (1 + α dt/2) = v_{n-1/2} (1 - α dt/2) + F dt/(ρ V)
///
/// Whatever α is, the velocity that is left lies between plus and minus what there was, so that damping limits no time step.
#pragma once

#include "fccda/core/vec3.hpp"

namespace perimpact {

/// The force density [N/m³] that leads to v_{n+1/2}, from that of all other forces, F/V, and v_{n-1/2} [m/s]; `damping`: α [1/s].
inline double damped(double force_density, double velocity, double density, double damping, double dt) {
  return (force_density - density * damping * velocity) / (1 + 0.5 * damping * dt);
}

/// What was added to forces on particles at an instant.
struct Resistance {
  fccda::Vec3d force{};  ///< [N]
  double power = 0;      ///< [W] at the mean of the velocities before and after the kick
  Resistance& operator+=(const Resistance& other) {
    force += other.force, power += other.power;
    return *this;
  }
};

/// That of one particle whose force density was changed from `before` to `after`.
inline Resistance resistance(const fccda::Vec3d& before, const fccda::Vec3d& after, const fccda::Vec3d& velocity, double volume, double density, double dt) {
  const fccda::Vec3d force = volume * (after - before);
  return {force, dot(force, velocity + 0.5 * dt / density * after)};
}

}  // namespace perimpact
