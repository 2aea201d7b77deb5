/// Implicit velocity damping, and the work of resisting forces, for the boundary conditions `absorbing` and `floating`.
///
///   v_{n+1/2} (1 + α dt/2) = v_{n-1/2} (1 - α dt/2) + F dt/(ρ V)
///
/// For any α the remaining velocity lies between plus and minus the previous one, so that damping does not limit the time step.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// The force density [N/m³] that leads to v_{n+1/2}, from that of all other forces, F/V, and v_{n-1/2} [m/s]; `damping`: α [1/s].
inline double damped(double force_density, double velocity, double density, double damping, double dt) {
  return (force_density - density * damping * velocity) / (1 + 0.5 * damping * dt);
}

/// Resultant of forces on particles at an instant, and their work.
struct Resistance {
  fccda::Vec3d force{};  ///< [N] their sum
  double work = 0;       ///< [J] since the previous instant
  Resistance& operator+=(const Resistance& other) {
    force += other.force, work += other.work;
    return *this;
  }
};

/// Trapezoidal work of forces on particles: the mean of the forces at two instants times the displacement in between, including that by
/// contact (reaction_ledger.hpp). Initially the forces are 0.
class ForcesOnTheWay {
 public:
  explicit ForcesOnTheWay(std::size_t particles) : latest_(3 * particles, 0.0) {}

  /// Records the force [N] on a particle at an instant, reached by the displacement `way` [m].
  Resistance record_force(std::size_t particle, const fccda::Vec3d& force, const fccda::Vec3d& way) {
    double* latest = latest_.data() + 3 * particle;
    const Resistance noted{force, 0.5 * dot(fccda::Vec3d{latest[0], latest[1], latest[2]} + force, way)};
    latest[0] = force.x, latest[1] = force.y, latest[2] = force.z;
    return noted;
  }

  /// `slots`: of the particles.
  template <class Visitor>
  void visit_record(const std::string& name, std::span<const std::uint32_t> slots, Visitor&& visit) {
    visit(name + ".latest_forces", ListNumbers(std::span<double>(latest_), slots));
  }

 private:
  std::vector<double> latest_;  // [N] three of each particle
};

}  // namespace perimpact
