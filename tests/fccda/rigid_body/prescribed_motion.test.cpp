#include "fccda/rigid_body/prescribed_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

RigidBodyProperties lopsided() {
  return {.mass = 2.5, .centre_of_mass = {0.1, -0.2, 0.05}, .inertia = {{{0.31, 0.02, -0.01}, {0.02, 0.22, 0.03}, {-0.01, 0.03, 0.15}}}};
}

Step step_number(long n, double dt) { return {static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, dt}; }

}  // namespace

TEST_CASE("prescribed motion: a table of displacements is reproduced at each of ten thousand steps") {
  const PiecewiseLinear heave({0.01, 0.3, 0.34, 0.9}, {0.5, 1.7, -0.4, 0.1});
  const double dt = 1e-4;
  RigidBody body(lopsided(), Pose({1, 2, 3}), {}, {}, {});
  const double start = body.position_of_com().z;
  PrescribedMotion motion;
  motion.prescribe(2, PrescribedMotion::Of::displacement, heave);
  for (long n = 0; n < 10'000; ++n) {
    const Step step = step_number(n, dt);
    motion.impose(body, step);
    body.advance(dt);
    // each step rounds a position of up to 5 m once, and n dt once: worst case, all to one side
    REQUIRE(std::fabs(body.position_of_com().z - start - (heave.at(step.t1) - heave.at(0))) <= static_cast<double>(n + 2) * 5 * eps);
  }
  CHECK(body.velocity().z == 0);  // rest beyond the last time
  CHECK(body.position_of_com().x == 1.1);
}

TEST_CASE("prescribed motion: a table of velocities gives the displacement of its integral, with kinks within steps, and continues with the last one") {
  const PiecewiseLinear surge({0, 0.123, 0.2001}, {0, 4, 1});
  RigidBody body(lopsided(), Pose(), {}, {}, {});
  const double start = body.position_of_com().x;
  PrescribedMotion motion;
  motion.prescribe(0, PrescribedMotion::Of::velocity, surge);
  const double dt = 1e-2;
  for (long n = 0; n < 100; ++n) {
    motion.impose(body, step_number(n, dt));
    body.advance(dt);
  }
  const double area = 0.5 * 4 * 0.123 + 2.5 * (0.2001 - 0.123) + 1 * (1 - 0.2001);
  CHECK(std::fabs(body.position_of_com().x - start - area) < 300 * eps);  // 100 steps that round numbers of order 1 up to three times
  CHECK(body.velocity().x == 1);
}

TEST_CASE("prescribed motion: an angle about one axis as a function of time is reproduced") {
  const PiecewiseLinear swing({0, 0.25, 1}, {0, 2.5, -1});
  RigidBody body(lopsided(), Pose(), {}, {}, {});
  PrescribedMotion motion;
  motion.prescribe(4, PrescribedMotion::Of::displacement, swing);
  const double dt = 1e-3;
  for (long n = 0; n < 1000; ++n) {
    const Step step = step_number(n, dt);
    motion.impose(body, step);
    body.advance(dt);
    const double angle = swing.at(step.t1);
    const Vec3d turned = body.pose().turn_to_world({1, 0, 0});
    REQUIRE(norm(turned - Vec3d{std::cos(angle), 0, -std::sin(angle)}) < 1e-12);  // a thousand products of quaternions, eps each
  }
}

TEST_CASE("prescribed motion: the constraint work and the work of external impulses equal the gain of kinetic energy") {
  // rotated about x and towed along y while the other degrees are free, with products of inertia that couple the rotations
  PrescribedMotion motion;
  motion.prescribe(1, PrescribedMotion::Of::velocity, PiecewiseLinear({0, 0.5}, {0, 3}));
  motion.prescribe(3, PrescribedMotion::Of::velocity, PiecewiseLinear({0, 0.5}, {0, 6}));
  const auto imbalance = [&](double dt) {
    RigidBody body(lopsided(), Pose(), {0.3, 0, 0.1}, {0, 1, 2}, {{true, false, true, false, true, true}});
    const double before = body.kinetic_energy();
    double work = 0;
    for (long n = 0; n < std::lround(0.5 / dt); ++n) {
      motion.impose(body, step_number(n, dt));
      body.advance(dt);
      const Vec3d push{0.1 * dt, 2 * dt, 0}, twist{0.3 * dt, 0.1 * dt, 0}, velocity = body.velocity(), spin = body.angular_velocity();
      body.add_impulse(push, twist);
      work += 0.5 * (dot(velocity + body.velocity(), push) + dot(spin + body.angular_velocity(), twist));
    }
    CHECK(body.constraint_work() > 5);
    return std::fabs(body.kinetic_energy() - before - work - body.constraint_work());
  };
  // the error of free rotation itself, of fourth order (rigid_body.test.cpp): of 6 J, turning by up to 0.06 in a step
  const double coarse = imbalance(1e-2), fine = imbalance(5e-3);
  CHECK(coarse < 1e-4 * 6);
  CHECK(coarse / fine > 12);  // 16, and the next order is (ω dt)² smaller
}

TEST_CASE("prescribed motion: degrees that are not prescribed keep their velocity, and tables define the initial one of the others") {
  PrescribedMotion motion;
  CHECK(motion.is_empty());
  motion.prescribe(0, PrescribedMotion::Of::displacement, PiecewiseLinear({0, 2}, {5, 9}));
  CHECK(!motion.is_empty());
  CHECK(motion.velocity_at(0, 0, 7) == 2);
  CHECK(motion.velocity_at(1, 0, 7) == 7);
}
