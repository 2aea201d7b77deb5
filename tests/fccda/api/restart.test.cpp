// A run that is stopped and restarted with new detectors.
#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/detect/scene.hpp"

using namespace fccda;

namespace {

constexpr double r = 0.05, dt = 0.01;  // [m], [s]

/// A square of 1 m in the plane z = 0, front towards +z.
Surface plate() {
  Panels square;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) square.vertices.push_back({0.25 * i - 0.5, 0.25 * j - 0.5, 0});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) square.add_quad(5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5);
  return Surface(square, {.orientation = Orientation::normals});
}

/// Two open plates face each other and close on points between them, so that each pushes them against the other; then they open again.
struct Press {
  std::vector<Vec3d> x_t0, x, v;
  RigidBody low{{.mass = 1}, Pose(), {}, {}, {}}, high{{.mass = 1}, Pose({0, 0, 0.3}, Quaternion::from_rotation({std::numbers::pi, 0, 0})), {}, {}, {}};
  std::vector<Contact> all;

  Press() {
    std::mt19937_64 random(31);
    for (int i = 0; i < 60; ++i) {
      x.push_back(fixtures::random_in_box(random, {-0.45, -0.45, 0.1}, {0.45, 0.45, 0.2}));
      v.push_back(fixtures::random_in_box(random, {-0.1, -0.1, -2}, {0.1, 0.1, 2}));
    }
  }

  void run(ContactDetector& below, ContactDetector& above, int from, int to) {
    for (int step = from; step < to; ++step) {
      high.drive(2, step < 40 ? -0.55 : 0.5);  // down to a gap of 0.08, less than the balls are wide
      x_t0 = x;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
      const Motion low_motion = low.advance(dt), high_motion = high.advance(dt);
      hit(below, low, low_motion, above);  // one detection each: penetration caused by the other is resolved in the next step
      hit(above, high, high_motion, below);
    }
  }

  void hit(ContactDetector& detector, RigidBody& body, const Motion& motion, ContactDetector& other) {
    const std::vector<Contact> contacts = detector.detect(motion, x_t0, x);
    respond(contacts, motion, body, {.x_t0 = x_t0, .x_t1 = x, .velocity = v, .mass = 1.0}, 0.2);
    for (const Contact& contact : contacts) other.moved(contact.point);
    all.insert(all.end(), contacts.begin(), contacts.end());
  }
};

bool same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& p, const Contact& q) {
    return p.point == q.point && p.panel == q.panel && p.time_fraction == q.time_fraction && p.hit == q.hit && p.normal == q.normal &&
           p.relocation == q.relocation && p.depth == q.depth;
  });
}

}  // namespace

TEST_CASE("plain call: with a detector's state a restart of open surfaces is bitwise exact, and without it it is not") {
  Press whole;
  ContactDetector below(plate(), {.radius = r}), above(plate(), {.radius = r});
  whole.run(below, above, 0, 80);
  CHECK(whole.all.size() > 500);
  std::size_t others_without = 0;
  for (int stop = 30; stop <= 44; stop += 2) {
    CAPTURE(stop);
    Press first;
    ContactDetector a(plate(), {.radius = r}), b(plate(), {.radius = r});
    first.run(a, b, 0, stop);
    Press second = first, forgetful = first;
    ContactDetector c(plate(), {.radius = r}), d(plate(), {.radius = r});
    c.resume(a.state()), d.resume(b.state());
    second.run(c, d, stop, 80);
    CHECK(same(second.all, whole.all));
    CHECK(second.x == whole.x);
    ContactDetector e(plate(), {.radius = r}), f(plate(), {.radius = r});
    forgetful.run(e, f, stop, 80);
    others_without += !same(forgetful.all, whole.all);
  }
  CHECK(others_without > 0);
}

TEST_CASE("plain call: an invalid state is rejected with a message") {
  ContactDetector detector(plate(), {.radius = r});
  CHECK_THROWS_WITH_AS(detector.resume({.in_contact = {3, 1}}),
                       "contact: the points of a detector's state are not in ascending order; pass what state() returned.", InputError);
}
