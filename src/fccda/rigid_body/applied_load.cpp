#include "fccda/rigid_body/applied_load.hpp"

namespace fccda {

namespace {

/// Speed of the centre of mass along the force [m/s]; 0 without a force.
double speed_along(const Vec3d& force, const Vec3d& velocity) {
  const double magnitude = norm(force);
  return magnitude > 0 ? dot(velocity, force) / magnitude : 0;
}

}  // namespace

double apply(std::span<const AppliedLoad> loads, RigidBody& body, const Step& step) {
  if (loads.empty()) return 0;
  const Vec3d velocity = body.velocity(), spin = body.angular_velocity();
  Vec3d impulse{}, angular_impulse{};
  for (const AppliedLoad& load : loads) {
    const double seconds = step.dt * load.factor.mean(step.t0, step.t1) * load.speed_factor.at(speed_along(load.force, velocity));  // of the full load
    const Vec3d linear = seconds * load.force;
    impulse += linear;
    angular_impulse += seconds * load.moment;
    if (load.point) angular_impulse += cross(body.pose().to_world(*load.point) - body.position_of_com(), linear);
  }
  body.add_impulse(impulse, angular_impulse);
  return 0.5 * (dot(velocity + body.velocity(), impulse) + dot(spin + body.angular_velocity(), angular_impulse));
}

}  // namespace fccda
