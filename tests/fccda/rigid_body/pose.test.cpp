#include "fccda/rigid_body/pose.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace fccda;

namespace {

Quaternion scaled(const Quaternion& q, double by) { return {by * q.w, by * q.x, by * q.y, by * q.z}; }

const Quaternion oblique = Quaternion::from_rotation({0.5, 0.7, -0.3});

}  // namespace

TEST_CASE("pose: an attitude within the accepted 1e-6 of unit length rotates as that of unit length, and is stored as it is") {
  for (const double length : {1 - 9e-7, 1 - 1e-9, 1.0, 1 + 1e-9, 1 + 9e-7}) {
    const Quaternion given = scaled(oblique, length);
    const Pose pose({1, 2, 3}, given), exact({1, 2, 3}, oblique);
    CHECK((pose.attitude().w == given.w && pose.attitude().x == given.x && pose.attitude().y == given.y && pose.attitude().z == given.z));
    const Vec3d point{4, -5, 6};
    // rounding of coordinates of 10
    CHECK(norm(pose.to_world(point) - exact.to_world(point)) == fixtures::absolute(0, 1e-14, "m"));
    CHECK(norm(pose.to_body(pose.to_world(point)) - point) == fixtures::absolute(0, 1e-14, "m"));
  }
}

TEST_CASE("pose: the matrix of an attitude that is of unit length to rounding is that of its components, bit for bit") {
  const Quaternion rounded = scaled(oblique, 1 + 4e-16);
  const Mat3 matrix = rounded.matrix();
  const Pose pose({}, rounded);
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) CHECK(pose.turn_to_world(axis) == matrix * axis);
}

TEST_CASE("pose: no point is inside after the response to contact with a body whose attitude is of unit length to 1e-6") {
  for (const double length : {1 - 9e-7, 1 + 9e-7}) {
    ContactDetector detector(Surface(make_box({.size = {10, 10, 10}})), {.radius = 0.01});
    const Pose pose({}, scaled(oblique, length));
    const Motion motion{pose, pose, 1, {}};
    RigidBody body({.mass = 1}, pose, {}, {}, {});
    const Pose exact({}, oblique);
    std::vector<Vec3d> x_t0, x_t1, velocity;
    for (int k = 0; k < 50; ++k) {
      const Vec3d place = exact.to_world({0.19 * k - 4.7, 1.1, 0}), up = exact.turn_to_world({0, 0, 1});
      x_t0.push_back(place + 6.0 * up), x_t1.push_back(place + 4.9 * up), velocity.push_back(-1.1 * up);
    }
    CHECK(respond(detector.detect(motion, x_t0, x_t1), motion, body, {x_t0, x_t1, velocity, 1.0}).contacts == 50);
    CHECK(detector.points_inside(pose, x_t1).empty());
    // the contact radius from the face, and beyond by the offset of 1e-11 m
    for (const Vec3d& x : x_t1) CHECK(exact.to_body(x).z == fixtures::absolute(5.01, 1e-10, "m"));
  }
}
