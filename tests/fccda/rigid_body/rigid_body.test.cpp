#include "fccda/rigid_body/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr FreeDegrees all_free{{true, true, true, true, true, true}};

RigidBodyProperties tumbling() {
  return {.mass = 2.5, .centre_of_mass = {0.1, -0.2, 0.05}, .inertia = {{{0.31, 0.02, -0.01}, {0.02, 0.22, 0.03}, {-0.01, 0.03, 0.15}}}};
}

RigidBody tumbling_body(const FreeDegrees& degrees = all_free) {
  return RigidBody(tumbling(), Pose({1, 2, 3}, Quaternion::from_rotation({0.4, -0.7, 0.2})), {3, -1, 2}, {2, 5, -3}, degrees);
}

}  // namespace

TEST_CASE("pose: a point transformed to the body frame and back is the same point") {
  const Pose pose({1, 2, 3}, Quaternion::from_rotation({0.4, -0.7, 2.2}));
  const Vec3d point{0.3, -0.8, 1.7};
  CHECK(norm(pose.to_world(pose.to_body(point)) - point) < 1e-15);  // four roundings of numbers of order one
  CHECK(norm(pose.turn_to_body(pose.turn_to_world(point)) - point) < 1e-15);
}

TEST_CASE("rigid body: without torque, linear and angular momentum of a tumbling body are conserved to rounding") {
  RigidBody body = tumbling_body();
  const Vec3d momentum = body.momentum(), angular = body.angular_momentum({});
  for (int step = 0; step < 10'000; ++step) body.advance(1e-3);
  // 10 000 steps, each rounding numbers of order ten: 1e4 × 1e-15 × 10, and as much again by the growing arm
  CHECK(norm(body.momentum() - momentum) == 0);
  CHECK(norm(body.angular_momentum({}) - angular) < 1e-9);
}

TEST_CASE("rigid body: the energy error of tumbling is of fourth order in the step") {
  const auto error = [](double dt) {
    RigidBody body = tumbling_body();
    const double before = body.kinetic_energy();
    for (double t = 0; t < 2; t += dt) body.advance(dt);
    return std::fabs(body.kinetic_energy() - before) / before;
  };
  const double coarse = error(0.04), fine = error(0.02);
  CHECK(coarse < 1e-2);       // (ω dt)⁴ with ω dt = 0.25
  CHECK(coarse / fine > 12);  // 16, and the next order is (ω dt)² smaller
}

TEST_CASE("rigid body: over a thousand revolutions energy is conserved to 1e-6 and angular momentum to 1e-12, about any axis") {
  for (const Vec3d& spin : {Vec3d{5, 0.2, 0.3}, Vec3d{0.01, 5, 0.01}, Vec3d{0.3, 0.2, 5}}) {
    RigidBody body({.mass = 1000, .inertia = Mat3::diagonal({100, 200, 300})}, Pose(), {}, spin, all_free);
    const double dt = 0.02 / norm(spin), energy = body.kinetic_energy();  // four times the recommended step
    const Vec3d angular = body.angular_momentum({});
    double worst = 0, furthest = 0;
    for (int step = 0; step < 315'000; ++step) {
      body.advance(dt);
      if (step % 16 != 0) continue;
      worst = fixtures::larger(worst, std::fabs(body.kinetic_energy() / energy - 1));
      furthest = fixtures::larger(furthest, norm(body.angular_momentum({}) - angular) / norm(angular));
    }
    CHECK(worst < 1e-6);
    CHECK(furthest < 1e-12);
  }
}

TEST_CASE("rigid body: spinning about its intermediate axis it flips at the times of Euler's equations, over ten periods") {
  const Vec3d inertia{100, 200, 300};
  // Euler's equations in the body frame, by the Runge–Kutta method of fourth order with steps a twentieth of the body's
  const auto rate = [&](const Vec3d& w) {
    return Vec3d{(inertia.y - inertia.z) * w.y * w.z / inertia.x, (inertia.z - inertia.x) * w.z * w.x / inertia.y,
                 (inertia.x - inertia.y) * w.x * w.y / inertia.z};
  };
  const double dt = 1e-3;
  const int steps = 110'000;
  const Vec3d start{0.01, 5, 0.01};
  std::vector<double> expected, found;
  const auto note = [&](std::vector<double>& flips, double time, double before, double after) {
    if (before * after < 0) flips.push_back(time - dt * after / (after - before));
  };
  Vec3d w = start;
  for (int step = 1; step <= steps; ++step) {
    const double before = w.y, h = dt / 20;
    for (int part = 0; part < 20; ++part) {
      const Vec3d a = rate(w), b = rate(w + 0.5 * h * a), c = rate(w + 0.5 * h * b), d = rate(w + h * c);
      w += (h / 6) * (a + 2.0 * b + 2.0 * c + d);
    }
    note(expected, step * dt, before, w.y);
  }
  RigidBody body({.mass = 1000, .inertia = Mat3::diagonal(inertia)}, Pose(), {}, start, all_free);
  double before = start.y;
  for (int step = 1; step <= steps; ++step) {
    body.advance(dt);
    const double now = body.pose().turn_to_body(body.angular_velocity()).y;
    note(found, step * dt, before, now);
    before = now;
  }
  REQUIRE(expected.size() >= 20);  // two flips per period
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k] == fixtures::relative(expected[k], 1e-4));  // (ω dt)⁴, amplified by each flip
}

TEST_CASE("rigid body: rotating freely about two world axes, with the third constrained, it conserves energy and its angular momentum along them") {
  for (const double held : {0.0, 1.0}) {
    FreeDegrees degrees = all_free;
    degrees.free[5] = false;
    RigidBody body(tumbling(), Pose(), {}, {2, 5, held}, degrees);
    const double energy = body.kinetic_energy();
    const Vec3d angular = body.angular_momentum(body.position_of_com());
    for (int step = 0; step < 20'000; ++step) body.advance(1e-3);
    CHECK(body.kinetic_energy() - body.constraint_work() == fixtures::relative(energy, 1e-9));  // (ω dt)⁴
    CHECK(body.angular_velocity().z == held);
    const Vec3d now = body.angular_momentum(body.position_of_com());
    CHECK(now.x == fixtures::relative(angular.x, 1e-12));
    CHECK(now.y == fixtures::relative(angular.y, 1e-12));
  }
}

TEST_CASE("rigid body: a rotation about a principal axis continues at a constant rate") {
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::diagonal({1, 2, 3})}, Pose(), {}, {0, 0, 0.5}, all_free);
  for (int step = 0; step < 1000; ++step) body.advance(0.01);
  CHECK(norm(body.angular_velocity() - Vec3d{0, 0, 0.5}) < 1e-13);  // rounding of 1000 steps
  CHECK(norm(body.pose().turn_to_world({1, 0, 0}) - Vec3d{std::cos(5.0), std::sin(5.0), 0}) < 1e-12);
}

TEST_CASE("rigid body: an off-centre impulse on a free body adds exactly that momentum and moment") {
  RigidBody body = tumbling_body();
  const Vec3d momentum = body.momentum(), angular = body.angular_momentum(body.position_of_com());
  const Vec3d linear{0.4, -2, 1}, moment{0.7, 0.1, -0.3};
  body.add_impulse(linear, moment);
  CHECK(norm(body.momentum() - momentum - linear) < 1e-14);
  CHECK(norm(body.angular_momentum(body.position_of_com()) - angular - moment) < 1e-14);
}

TEST_CASE("rigid body: constrained components keep their velocity exactly, free ones respond as if the others were bearings") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (unsigned mask = 0; mask < 64; ++mask) {
    FreeDegrees degrees;
    for (std::size_t d = 0; d < 6; ++d) degrees.free[d] = (mask >> d) & 1u;
    RigidBody body = tumbling_body(degrees);
    const Vec3d v = body.velocity(), w = body.angular_velocity(), angular = body.angular_momentum(body.position_of_com());
    const Vec3d linear{any(random), any(random), any(random)}, moment{any(random), any(random), any(random)};
    body.add_impulse(linear, moment);
    const Vec3d gained = body.angular_momentum(body.position_of_com()) - angular;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (degrees.translation(axis))
        CHECK(body.velocity()[axis] == fixtures::relative(v[axis] + linear[axis] / 2.5, 1e-14));
      else
        CHECK(body.velocity()[axis] == v[axis]);
      if (degrees.rotation(axis))
        CHECK(std::fabs(gained[axis] - moment[axis]) < 1e-14);  // bearings take no moment along a free axis
      else
        CHECK(body.angular_velocity()[axis] == w[axis]);
    }
    body.advance(1e-3);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!degrees.rotation(axis)) CHECK(body.angular_velocity()[axis] == w[axis]);
  }
}

TEST_CASE("rigid body: prescribing constrained degrees changes no momentum along the free ones, and the kinetic energy is the constraint work") {
  RigidBody body = tumbling_body({{true, false, true, false, true, true}});
  const Vec3d angular = body.angular_momentum(body.position_of_com());
  const double before = body.kinetic_energy();
  body.drive(1, 7), body.drive(3, -4);
  CHECK(body.velocity() == Vec3d{3, 7, 2});
  CHECK(body.angular_velocity().x == -4);
  const Vec3d gained = body.angular_momentum(body.position_of_com()) - angular;
  CHECK(std::fabs(gained.x) > 0.1);
  CHECK(std::fabs(gained.y) < 1e-15 * 4);  // products of inertia would bring some; two roundings of numbers of order one
  CHECK(std::fabs(gained.z) < 1e-15 * 4);
  CHECK(body.constraint_work() == fixtures::relative(body.kinetic_energy() - before, 1e-14));
}

TEST_CASE("rigid body: no point of it moves farther in a step than its travel bound") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  const double radius = 0.7;
  for (const double dt : {1e-4, 1e-2, 0.2}) {
    RigidBody body = tumbling_body();
    const Vec3d centre = body.properties().centre_of_mass;
    const Motion motion = body.advance(dt);
    const double bound = body.travel_bound(motion, radius);
    double furthest = 0;
    for (int trial = 0; trial < 1000; ++trial) {
      const Vec3d point = centre + radius * normalised(Vec3d{any(random), any(random), any(random)});
      furthest = fixtures::larger(furthest, norm(motion.t1.to_world(point) - motion.t0.to_world(point)));
    }
    CHECK(furthest <= bound);
    CHECK(furthest > 0.5 * bound);  // a bound, not an estimate: translation and rotation add up in one direction only
  }
}

TEST_CASE("rigid body: a saved and restored state continues bitwise identically") {
  RigidBody body = tumbling_body(), twin = tumbling_body();
  for (int step = 0; step < 100; ++step) body.advance(1e-3);
  std::vector<double> stored;
  body.visit_state([&](std::string_view, std::span<double> values) { stored.insert(stored.end(), values.begin(), values.end()); });
  CHECK(stored.size() == 14);
  std::size_t next = 0;
  twin.visit_state([&](std::string_view, std::span<double> values) {
    for (double& value : values) value = stored[next++];
  });
  for (int step = 0; step < 100; ++step) {
    const Motion a = body.advance(1e-3), b = twin.advance(1e-3);
    REQUIRE(a.t1.to_world({1, 2, 3}) == b.t1.to_world({1, 2, 3}));
  }
  CHECK(body.angular_velocity() == twin.angular_velocity());
}

TEST_CASE("rigid body: a mass that is not positive and an inertia that is not positive definite for a free rotation are rejected") {
  CHECK_THROWS_AS(RigidBody({.mass = 0}, Pose(), {}, {}, {}), InputError);
  CHECK_THROWS_AS(RigidBody({.mass = 1}, Pose(), {}, {}, {{false, false, false, false, false, true}}), InputError);
  CHECK_NOTHROW(RigidBody({.mass = 1}, Pose(), {}, {}, {{true, true, true}}));
}

TEST_CASE("rigid body: an inertia that is not symmetric is rejected, one that is but for rounding is not") {
  Mat3 inertia = Mat3::diagonal({2, 3, 4});
  inertia.row[0].y = 0.5, inertia.row[1].x = 0.5 + 1e-15;
  CHECK_NOTHROW(RigidBody({.mass = 1, .inertia = inertia}, Pose(), {}, {}, {}));
  inertia.row[1].x = -0.5;
  CHECK_THROWS_WITH_AS(RigidBody({.mass = 1, .inertia = inertia}, Pose(), {}, {}, {}),
                       "rigid body: the inertia is not symmetric: -0.5 and 0.5 kg m2 must be equal.", InputError);
}

TEST_CASE("rigid body: numbers that are not finite, negative steps and rotations by more than half a revolution are rejected") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const RigidBodyProperties unit{.mass = 1, .inertia = Mat3::identity()};
  const auto refused = [](const auto& act) { CHECK_THROWS_AS(act(), InputError); };
  for (const double bad : {nan, infinity, -infinity}) {
    refused([&] { RigidBody({.mass = bad}, Pose(), {}, {}, {}); });
    refused([&] { RigidBody({.mass = 1, .centre_of_mass = {0, bad, 0}}, Pose(), {}, {}, {}); });
    refused([&] { RigidBody({.mass = 1, .inertia = Mat3::diagonal({1, bad, 1})}, Pose(), {}, {}, {}); });
    refused([&] { RigidBody({.mass = 1, .added_mass = {0, 0, bad}}, Pose(), {}, {}, {}); });
    refused([&] { RigidBody(unit, Pose({bad, 0, 0}), {}, {}, {}); });
    refused([&] { RigidBody(unit, Pose({}, {bad, 0, 0, 0}), {}, {}, {}); });
    refused([&] { RigidBody(unit, Pose(), {0, bad, 0}, {}, {}); });
    refused([&] { RigidBody(unit, Pose(), {}, {0, 0, bad}, {}); });
    RigidBody body(unit, Pose(), {}, {}, {{true, true, true, false, false, false}});
    refused([&] { body.advance(bad); });
    refused([&] { body.add_impulse({bad, 0, 0}, {}); });
    refused([&] { body.add_impulse({}, {0, bad, 0}); });
    refused([&] { body.drive(3, bad); });
    CHECK((body.velocity() == Vec3d{} && body.angular_velocity() == Vec3d{}));  // rejected input has no effect
  }
  refused([&] { RigidBody(unit, Pose({}, {2, 0, 0, 0}), {}, {}, {}); });
  RigidBody top(unit, Pose(), {}, {0, 0, 10}, {{true, false, false, false, false, false}});
  CHECK_THROWS_WITH_AS(top.advance(-1), "rigid body: the step lasts -1 s, but it must be finite and not negative.", InputError);
  CHECK_THROWS_WITH_AS(top.advance(0.5),
                       "rigid body: it turns by 5 rad in a step of 0.5 s, but the poses at its ends determine at most half a turn; use a shorter step.",
                       InputError);
  CHECK_NOTHROW(top.advance(0.3));
  refused([&] { top.drive(0, 1); });  // free
  refused([&] { top.drive(6, 1); });
}
