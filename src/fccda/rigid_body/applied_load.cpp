#include "fccda/rigid_body/applied_load.hpp"

namespace fccda {

double apply(std::span<const AppliedLoad> loads, RigidBody& body, const Step& step) {
  if (loads.empty()) return 0;
  Vec3d impulse{}, angular_impulse{};
  for (const AppliedLoad& load : loads) {
    const double seconds = step.dt * load.factor.mean(step.t0, step.t1);  // of the full load
    const Vec3d linear = seconds * load.force;
    impulse += linear;
    angular_impulse += seconds * load.moment;
    if (load.point) angular_impulse += cross(body.pose().to_world(*load.point) - body.position_of_com(), linear);
  }
  const Vec3d velocity = body.velocity(), spin = body.angular_velocity();
  body.add_impulse(impulse, angular_impulse);
  return 0.5 * (dot(velocity + body.velocity(), impulse) + dot(spin + body.angular_velocity(), angular_impulse));
}

}  // namespace fccda
