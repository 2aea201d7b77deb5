#include "fccda/rigid_body/applied_load.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr FreeDegrees all_free{{true, true, true, true, true, true}};

RigidBodyProperties lopsided() {
  return {.mass = 2.5, .centre_of_mass = {0.1, -0.2, 0.05}, .inertia = {{{0.31, 0.02, -0.01}, {0.02, 0.22, 0.03}, {-0.01, 0.03, 0.15}}}};
}

/// Work of the loads [J].
double run(RigidBody& body, std::span<const AppliedLoad> loads, double end, double dt) {
  double work = 0;
  for (long n = 0; n < std::lround(end / dt); ++n) {
    work += apply(loads, body, {static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, dt});
    body.advance(dt);
  }
  return work;
}

}  // namespace

TEST_CASE("applied load: under its weight a body follows a parabola, and the work equals the kinetic energy") {
  const AppliedLoad weight[] = {{.force = {0, 0, -2.5 * 9.81}}};
  RigidBody body(lopsided(), Pose(), {2, 0, 5}, {}, all_free);
  const Vec3d start = body.position_of_com();
  const double before = body.kinetic_energy(), dt = 1e-3;
  const double work = run(body, weight, 1, dt);
  // symplectic Euler moves with the velocity at the end of the step: g t (t + dt)/2 in place of g t²/2, exactly
  CHECK(norm(body.position_of_com() - start - Vec3d{2, 0, 5 - 9.81 * 0.5 * (1 + dt)}) < 1e-11);  // a thousand roundings of 5 m
  CHECK(norm(body.velocity() - Vec3d{2, 0, 5 - 9.81}) < 1e-11);
  CHECK(norm(body.angular_velocity()) == 0);
  CHECK(work == fixtures::relative(body.kinetic_energy() - before, 1e-12));  // exact in each step, so rounding is left
}

TEST_CASE("applied load: without a moment a tumbling body conserves angular momentum, whatever force acts at its centre of mass") {
  const AppliedLoad push[] = {{.force = {3, -4, 1}}};
  RigidBody body(lopsided(), Pose(), {}, {2, 5, -3}, all_free);
  const Vec3d before = body.angular_momentum(body.position_of_com());
  run(body, push, 1, 1e-3);
  CHECK(norm(body.angular_momentum(body.position_of_com()) - before) < 1e-12);  // a thousand roundings of 1 kg m²/s
}

TEST_CASE("applied load: a constant torque about a bearing's axis spins up at M/I") {
  const AppliedLoad torque[] = {{.moment = {0, 0, 0.6}}};
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::diagonal({1, 2, 3})}, Pose(), {}, {}, {{false, false, false, false, false, true}});
  const double work = run(body, torque, 2, 1e-3);
  CHECK(body.angular_velocity().z == fixtures::relative(0.6 / 3 * 2, 1e-12));
  CHECK(work == fixtures::relative(0.5 * 3 * 0.4 * 0.4, 1e-12));
}

TEST_CASE("applied load: a force off the centre of mass has the moment of its lever arm, which rotates with the body") {
  const Vec3d arm{0, 0.5, 0};
  const AppliedLoad thrust[] = {{.force = {2, 0, 0}, .point = Vec3d{0.1, -0.2, 0.05} + arm}};
  RigidBody body(lopsided(), Pose({}, Quaternion::from_rotation({0, 0, 0.7})), {}, {}, all_free);
  const double dt = 1e-3;
  apply(thrust, body, {0, dt, dt});
  const Vec3d turned = body.pose().turn_to_world(arm);
  CHECK(norm(body.angular_momentum(body.position_of_com()) - cross(turned, Vec3d{2 * dt, 0, 0})) < 1e-17);
  CHECK(norm(body.momentum() - Vec3d{2 * dt, 0, 0}) < 1e-18);
}

TEST_CASE("applied load: its factor is the mean over the step") {
  const AppliedLoad blast[] = {{.force = {0, 10, 0}, .factor = PiecewiseLinear({0.1, 0.2, 0.3}, {0, 1, 0})}};
  RigidBody body(lopsided(), Pose(), {}, {}, all_free);
  run(body, blast, 0.5, 0.05);  // steps of a quarter of the pulse
  CHECK(body.momentum().y == fixtures::relative(10 * 0.1, 1e-13));
}

TEST_CASE("applied load: a thrust that falls linearly with speed approaches the speed at which it vanishes exponentially") {
  constexpr double thrust = 10, top_speed = 4, mass = 2.5, rate = thrust / (mass * top_speed), end = 1.5, dt = 1e-4;
  const AppliedLoad falling[] = {{.force = {0, -thrust, 0}, .speed_factor = PiecewiseLinear({-8, 8}, {3, -1})}};
  RigidBody body(lopsided(), Pose(), {7, 0, 0}, {}, all_free);
  const double before = body.kinetic_energy(), work = run(body, falling, end, dt), decay = std::exp(-rate * end);
  const double first_order = 0.5 * rate * dt * rate * end * decay * top_speed;  // of v, by taking the speed at the beginning of each step
  CHECK(std::fabs(body.velocity().y + top_speed * (1 - decay) + first_order) < 1e-3 * first_order);
  CHECK(body.velocity().x == 7);  // across the force
  CHECK(work == fixtures::relative(body.kinetic_energy() - before, 1e-12));
}

TEST_CASE("applied load: the speed factor is that of the speed along the force, and scales the moment too") {
  const AppliedLoad load[] = {{.force = {0, 0, -6}, .moment = {0, 2, 0}, .speed_factor = PiecewiseLinear({0, 10}, {0, 1})}};
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::diagonal({1, 1, 1})}, Pose(), {50, -70, -3}, {}, all_free);
  const double dt = 0.01;
  apply(load, body, {0, dt, dt});
  CHECK(body.velocity().z == fixtures::relative(-3 - 0.3 * 6 * dt, 1e-14));
  CHECK(body.angular_velocity().y == fixtures::relative(0.3 * 2 * dt, 1e-14));
}

TEST_CASE("applied load: loads on constrained degrees of freedom are balanced by reactions, and the energy balance closes") {
  const AppliedLoad thrust[] = {{.force = {100, 7, 0}, .moment = {0, 0.2, 30}, .point = Vec3d{}}};
  RigidBody body(lopsided(), Pose(), {3, 0, 0}, {0, 0, 4}, {{false, true, true, true, true, false}});
  const double before = body.kinetic_energy();
  const double work = run(body, thrust, 0.01, 1e-5);
  CHECK(body.velocity().x == 3);
  CHECK(body.angular_velocity().z == 4);
  CHECK(work > 3);  // 100 N at 3 m/s for 10 ms, and the moments
  // nearly zero in total: the remainder is the first-order error of the tumbling, 1e-5 s × 4 rad/s of the 2 J that turn
  CHECK(std::fabs(body.kinetic_energy() - before - work - body.constraint_work()) < 1e-4 * 2);
}
