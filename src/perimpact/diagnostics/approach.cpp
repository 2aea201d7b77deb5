#include "perimpact/diagnostics/approach.hpp"

#include <algorithm>
#include <limits>

#include "mesh/search/bvh.hpp"

namespace perimpact {

using namespace fccda;

Approach approach(const Impactor& impactor, const Particles& particles, double contact_radius, double end) {
  const Bvh bvh(impactor.surface());
  const RigidBody& start = impactor.body();
  const double radius = impactor.surface().radius_about(start.properties().centre_of_mass);
  const double turning = norm(start.angular_velocity()) * radius;  // [m/s] fastest point about the centre of mass
  const double tolerance = 1e-9 * norm(impactor.surface().report().bounds.size());

  Approach result{std::numeric_limits<double>::infinity(), std::nullopt};
  double latest = end;  // later contacts are irrelevant
  for (const std::uint32_t slot : particles.slot_of()) {
    const Vec3d x = particles.position.at(slot), v = particles.velocity.at(slot);
    const double speed = norm(v - start.velocity()) + turning;
    RigidBody moving = start;
    for (double time = 0, step = 0;;) {
      // beyond this distance the particle is in contact too late and is not the nearest at t = 0 either
      const double reach = speed * (latest - time) + contact_radius;
      const double cap = time == 0 ? std::max(reach, result.gap + contact_radius) : reach;
      const auto closest = bvh.closest(moving.pose().to_body(x + time * v), cap);
      if (!closest) break;
      const double gap = closest->distance - contact_radius;
      if (time == 0) result.gap = std::min(result.gap, std::max(gap, 0.0));
      if (gap <= tolerance) {
        latest = time;
        result.time = time;
        break;
      }
      if (speed == 0) break;
      step = gap / speed;
      if (time + step >= latest) break;
      moving.advance(step);
      time += step;
    }
    if (result.time && *result.time == 0) break;
  }
  return result;
}

}  // namespace perimpact
