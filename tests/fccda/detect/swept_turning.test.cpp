// Bodies with large rotations in a step.
#include <doctest/doctest.h>

#include <algorithm>

#include "fccda/detect/scene.hpp"
#include "fccda/detect/swept.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

/// A thin paddle that rotates about an axis beside it.
constexpr Vec3d half{0.5, 0.005, 0.15};
Panels paddle() {
  return fixtures::moved(make_box({.size = 2.0 * half, .edge_length = 0.1}), [](const Vec3d& p) { return p + Vec3d{0.6, 0, 0}; });
}

/// Signed distance from the paddle: the box's, in closed form.
double signed_distance(const Vec3d& point) {
  const Vec3d p = point - Vec3d{0.6, 0, 0};
  const Vec3d out{std::fabs(p.x) - half.x, std::fabs(p.y) - half.y, std::fabs(p.z) - half.z};
  return norm(max(out, Vec3d{})) + std::min(0.0, std::max({out.x, out.y, out.z}));
}

struct DisplacementHistory {
  double nearest = 1e300;  // signed distance over the step
  double first = 2;        // fraction of the step at which it is first nearer than r
};

/// The path of a point in ten thousand tiny steps of exact rotation.
DisplacementHistory course(const Motion& motion, const Vec3d& spin, const Vec3d& x0, const Vec3d& x1, double r) {
  constexpr int tiny = 10'000;
  DisplacementHistory result;
  for (int k = 0; k <= tiny; ++k) {
    const double s = static_cast<double>(k) / tiny;
    const Vec3d com = motion.t0.position() + s * (motion.t1.position() - motion.t0.position());  // the centre of mass is the origin
    const Vec3d y = x0 + s * (x1 - x0) - com;
    // Rodrigues: turned back by s |spin|, then into the body's frame at t0
    const double angle = -s * norm(spin);
    const Vec3d axis = normalised(spin);
    const Vec3d turned = std::cos(angle) * y + std::sin(angle) * cross(axis, y) + (1 - std::cos(angle)) * dot(axis, y) * axis;
    const double distance = signed_distance(motion.t0.turn_to_body(turned));
    result.nearest = std::min(result.nearest, distance);
    if (result.first > 1 && distance < r) result.first = s;
  }
  return result;
}

}  // namespace

TEST_CASE("swept, rotating: a thin paddle has exactly the contacts of ten thousand tiny steps, at up to half a radian per step") {
  const auto surface = fixtures::surface_of(paddle());
  const fixtures::Soup soup(*surface);
  const double radius = surface->radius_about({});
  std::mt19937_64 random(32);
  for (const double angle : {0.02, 0.1, 0.5}) {
    for (const double r : {0.0, 0.02}) {
      CAPTURE(angle);
      CAPTURE(r);
      const Vec3d spin = angle * normalised(Vec3d{0.1, 0.2, 1});
      RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose({3, 1, 2}, Quaternion::from_rotation({0.2, 0.5, 1})),
                     {0.03, -0.02, 0.01}, spin, {});
      const Motion motion = body.advance(1);
      fixtures::TestPoints points;
      std::vector<DisplacementHistory> truth;
      while (points.size() < 150) {
        // around the region swept by the paddle
        const Vec3d place = fixtures::random_in_box(random, {0.05, -0.05, -0.2}, {1.2, 0.05 + 1.2 * angle, 0.2});
        const Vec3d x0 = motion.t0.to_world(place), x1 = x0 + 0.1 * angle * fixtures::random_direction(random);
        if (signed_distance(place) < r + 1e-4) continue;
        const DisplacementHistory its = course(motion, spin, x0, x1, r);
        // Undecided: between tiny steps the paddle's tip moves on by 1.1 · 0.5/10 000.
        if (std::fabs(its.nearest - r) < 6e-5) continue;
        points.x0.push_back(x0), points.x1.push_back(x1);
        truth.push_back(its);
      }
      Swept detector(surface, Unbounded{}, r);
      const std::vector<Contact> contacts = detect(detector, points, motion, body.travel_bound(motion, radius));
      std::vector<bool> found(points.size(), false), expected;
      for (const Contact& contact : contacts) found[contact.point] = true;
      for (const DisplacementHistory& its : truth) expected.push_back(its.nearest < r);
      CHECK(found == expected);
      CHECK(contacts.size() > 10);  // the scene is not empty
      for (const Contact& contact : contacts) {
        const Vec3d place = motion.t1.to_body(contact.relocation);
        CHECK(signed_distance(place) > r - 5e-12);  // the offset is 32 ε times coordinates of 5
        CHECK_FALSE(soup.inside(place));
        CHECK(contact.time_fraction <= truth[contact.point].first + 1e-3);  // 1e-6 of way at a speed of 0.02 · 0.1, twice
        // Points pushed by the broad front face stay in front of it.
        const Vec3d hit = motion.t1.to_body(contact.hit);
        if (hit.y > 0.99 * half.y && std::fabs(hit.x - 0.6) < 0.4 && std::fabs(hit.z) < 0.1) CHECK(place.y > 0);
      }
    }
  }
}

TEST_CASE("swept, rotating: contact that a straight chord would miss is found, at the time at which the arc gets there") {
  // The arc of a point at rest, 1.1 from the axis, deviates from its chord by 1.1 (1 - cos 0.25) = 0.034; a peg lies in the bulge only.
  const double angle = 0.5;
  const auto peg = fixtures::surface_of(fixtures::moved(make_box({.size = {0.01, 0.01, 0.2}, .edge_length = 0.1}), [](const Vec3d& p) {
    return p + Vec3d{1.095, 0, 0};
  }));
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {}, {0, 0, angle}, {});
  const Motion motion = body.advance(1);
  fixtures::TestPoints points;
  points.x0 = points.x1 = {1.095 * Vec3d{std::cos(0.3), std::sin(0.3), 0}, 1.11 * Vec3d{std::cos(0.3), std::sin(0.3), 0}};
  Swept detector(peg, Unbounded{}, 0);
  const std::vector<Contact> contacts = detect(detector, points, motion, body.travel_bound(motion, 1.2));
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].point == 0);
  // The peg's leading face is 0.005 ahead of its middle: it meets the point after a rotation by asin(0.005/1.095) less than 0.3.
  CHECK(contacts[0].time_fraction == fixtures::relative((0.3 - std::asin(0.005 / 1.095)) / angle, 1e-5));  // the peg's size is 0.2: 2e-7/0.5 m
}

TEST_CASE("swept, rotating: points out of reach cost no more with rotation") {
  const auto surface = fixtures::surface_of(paddle());
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {}, {0, 0, 0.5}, {});
  const Motion motion = body.advance(1);
  fixtures::TestPoints points;
  std::mt19937_64 random(33);
  for (int i = 0; i < 1000; ++i) points.x0.push_back(fixtures::random_in_box(random, {-3, -3, 2}, {3, 3, 4}));
  points.x1 = points.x0;
  Swept detector(surface, Unbounded{}, 0.01);
  CHECK(detect(detector, points, motion, body.travel_bound(motion, 1.2)).empty());
  CHECK(detector.effort().points_tested == 0);
}
