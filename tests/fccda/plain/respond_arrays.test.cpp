#include "fccda/plain/respond_arrays.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "fccda/core/error.hpp"

using namespace fccda;

namespace {

RigidBody free_body(double mass) { return {{.mass = mass}, Pose(), {}, {}, {{true, true, true, false, false, false}}}; }

}  // namespace

TEST_CASE("plain response: a struck point is put back, gets the velocity that leads there, and the body what it lost") {
  RigidBody body = free_body(4);
  const Motion motion = body.advance(0.5);
  const std::vector<Contact> contacts{{.point = 1, .normal = {0, 0, 1}, .relocation = {1, 1, 1}}};
  const std::vector<double> x_t0{9, 9, 9, 1, 1, 2};
  std::vector<double> x_t1{8, 8, 8, 1, 1, 0}, velocity{-2, -2, -2, 0, 0, -4};
  const Tally tally = respond(contacts, motion, body, {x_t0, x_t1, velocity, 3.0});
  // by hand: v̄ = (1 - 2)/0.5 = -2, J = -3 (-2 - -4) = -6, V = -6/4
  CHECK(x_t1 == std::vector<double>{8, 8, 8, 1, 1, 1});
  CHECK(velocity == std::vector<double>{-2, -2, -2, 0, 0, -2});
  CHECK(tally.impulse == Vec3d{0, 0, -6});
  CHECK(tally.contacts == 1);
  CHECK(body.velocity() == Vec3d{0, 0, -1.5});

  const std::vector<double> masses{100, 3};
  RigidBody same = free_body(4);
  velocity[5] = -4, x_t1[5] = 0;
  CHECK(respond(contacts, same.advance(0.5), same, {x_t0, x_t1, velocity, masses}).impulse == tally.impulse);
}

TEST_CASE("plain response: arrays of different length and steps of no duration are refused") {
  RigidBody body = free_body(1);
  const Motion motion = body.advance(0.5);
  std::vector<Vec3d> two(2), three(3);
  const std::vector<double> masses(3), none;
  CHECK_THROWS_WITH_AS(respond({}, motion, body, {two, two, three, 1.0}),
                       "contact: the arrays of positions, velocities and masses are not equally long (2 positions at t0, 2 at t1, 3 velocities); give each for "
                       "every point.",
                       InputError);
  CHECK_THROWS_AS(respond({}, motion, body, {two, two, two, masses}), InputError);
  CHECK_THROWS_AS(respond({}, motion, body, {two, two, two, none}), InputError);
  CHECK_THROWS_AS(respond({}, motion, body, {two, three, two, 1.0}), InputError);
  CHECK_THROWS_WITH_AS(respond({}, Motion(), body, {two, two, two, 1.0}),
                       "contact: the step of the motion has no duration, but velocities need one; set Motion::dt.", InputError);
}
