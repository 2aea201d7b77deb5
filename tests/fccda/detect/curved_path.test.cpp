#include "fccda/detect/curved_path.hpp"

#include <doctest/doctest.h>

#include "fccda/detect/scene.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fixtures/larger.hpp"

using namespace fccda;

namespace {

/// A step of a body that translates and rotates by `angle` [rad] about its centre of mass, which is not its origin.
Motion turning(double angle) {
  const RigidBodyProperties properties{.mass = 1, .centre_of_mass = {0.2, -0.1, 0.3}, .inertia = Mat3::identity()};
  RigidBody body(properties, Pose({1, 2, 3}, Quaternion::from_rotation({0.3, 0.4, -0.2})), {0.3, 0, -0.2}, angle * normalised(Vec3d{1, -2, 2}), {});
  return body.advance(1);
}

double distance(const Vec3d& point, const Path& segment) {
  const Vec3d way = segment.end - segment.start;
  const double share = std::min(1.0, std::max(0.0, dot(point - segment.start, way) / dot(way, way)));
  return norm(point - segment.at(share));
}

}  // namespace

TEST_CASE("pose: in between, a body is where half a step would have moved it") {
  const RigidBodyProperties properties{.mass = 1, .centre_of_mass = {0.2, -0.1, 0.3}, .inertia = Mat3::identity()};
  RigidBody whole(properties, Pose({1, 2, 3}), {0.3, 0, -0.2}, {0.1, -1.2, 0.7}, {}), half = whole;
  const Pose there = pose_at(whole.advance(2), 0.5);
  half.advance(1);
  for (const Vec3d& point : {Vec3d{}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
    CHECK(norm(there.to_world(point) - half.pose().to_world(point)) < 1e-14);  // rounding of coordinates up to 3
}

TEST_CASE("curved path: no point of the true path is farther from the polyline than the tolerance, nor from the chord than the bulge") {
  std::mt19937_64 random(31);
  for (const double angle : {0.003, 0.05, 0.5, 1.5}) {
    CAPTURE(angle);
    const Motion motion = turning(angle);
    const BodyView view(motion, 1);
    for (int trial = 0; trial < 20; ++trial) {
      const Vec3d x_t0 = fixtures::random_in_box(random, {0, 1, 2}, {2, 3, 4}), x_t1 = x_t0 + 0.3 * fixtures::random_direction(random);
      const CurvedPath path = view.path(x_t0, x_t1);
      CHECK(path.parts() > 1);
      CHECK(path.parts() < BodyView::max_parts);
      double off_polyline = 0, off_chord = 0;
      for (int k = 0; k < path.parts(); ++k) {
        const Path part{path.place(k), path.place(k + 1)};
        CHECK(part.length() <= path.longest_part() * (1 + 1e-9));  // rounding
        for (const double s : {0.25, 0.5, 0.75}) {
          const double fraction = (k + s) / path.parts();
          const Vec3d there = pose_at(motion, fraction).to_body(x_t0 + fraction * (x_t1 - x_t0));
          off_polyline = fixtures::larger(off_polyline, distance(there, part));
          off_chord = fixtures::larger(off_chord, distance(there, path.chord()));
        }
      }
      CHECK(off_polyline < BodyView::straight_enough);
      CHECK(off_chord <= path.bulge() + 1e-14);  // rounding of coordinates up to 3
    }
  }
}

TEST_CASE("curved path: a step in which the arc stays within the tolerance is one straight part") {
  const Motion slow = turning(1e-5);  // 2 · 1e-5 / 8 of a path of 0.36 relative to the body
  const CurvedPath path = BodyView(slow, 1).path({2, 2, 3}, {2.001, 2, 3});
  CHECK(path.parts() == 1);
  CHECK(path.bulge() == 0);
  CHECK(BodyView(turning(0), 1).path({2, 2, 3}, {5, 2, 3}).parts() == 1);
}

TEST_CASE("curved path: the ends are exact, and the path of the next step begins exactly there") {
  RigidBody body({.mass = 1, .centre_of_mass = {0.2, 0, 0}, .inertia = Mat3::identity()}, Pose(), {0.1, 0, 0}, {0.4, 0.2, -0.1}, {});
  Vec3d x{1, 0.3, 0.2};
  Vec3d last_end = body.pose().to_body(x);
  for (int step = 0; step < 10; ++step) {
    const Motion motion = body.advance(1);
    const Vec3d next = x + Vec3d{0.01, -0.02, 0.03};
    const CurvedPath path = BodyView(motion, 1).path(x, next);
    CHECK(path.parts() > 100);
    CHECK(path.place(0) == last_end);
    CHECK(path.place(path.parts()) == motion.t1.to_body(next));
    last_end = path.place(path.parts());
    x = next;
  }
}

TEST_CASE("curved path: a step of any length is followed in a bounded number of parts") {
  const Motion motion = turning(3.1);
  const CurvedPath path = BodyView(motion, 1e-3).path({2, 2, 3}, {500, 2, 3});
  CHECK(path.parts() == BodyView::max_parts);
  CHECK(path.bulge() > 100);
  const double nan = std::nan("");
  CHECK(BodyView(motion, 1).path({nan, 0, 0}, {1, 0, 0}).parts() == 1);
}
