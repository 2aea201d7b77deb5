// What docs/library/README.md asks of the caller, and the limits that it states.
#include <doctest/doctest.h>

#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace fccda;

namespace {

const SharedSurface slab = share(Surface(make_box({.size = {10, 10, 1}})));
const Motion still{Pose(), Pose(), 1, {}};

Panels square() {
  Panels panels;
  panels.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  panels.add_quad(0, 1, 2, 3);
  return panels;
}

}  // namespace

TEST_CASE("promises: a step that is repeated from the state before it has the contacts of the first try, and without that state they are missed") {
  const std::vector<Vec3d> above{{0, 0, 2}}, away{{0, 0, 9}}, into{{0, 0, 0.2}};
  for (const bool resumes : {true, false}) {
    ContactDetector detector(slab, {.radius = 0.1});
    detector.detect(still, above, above);
    const ContactDetector::State state = detector.state();
    CHECK(detector.detect(still, above, away).empty());  // rejected
    if (resumes) detector.resume(state);
    CHECK(detector.detect(still, above, into).size() == (resumes ? 1 : 0));
  }
}

TEST_CASE("promises: a number that is used again between two steps is evaluated once it is reported as moved, or points as changed") {
  const std::vector<Vec3d> far{{0, 0, 1000}}, above{{0, 0, 1}}, into{{0, 0, 0}};
  const auto contacts = [&](const auto& report) {
    ContactDetector detector(slab, {.radius = 0.1});
    for (int step = 0; step < 3; ++step) detector.detect(still, far, far);
    report(detector);
    return detector.detect(still, above, into).size();
  };
  CHECK(contacts([](ContactDetector& detector) { detector.moved(0); }) == 1);
  CHECK(contacts([](ContactDetector& detector) { detector.points_changed(); }) == 1);
  CHECK(contacts([](ContactDetector&) {}) == 0);
}

TEST_CASE(
    "promises: points of mass m in all that lose the velocity u give a free body of mass M the energy (m u)^2/(2 M), more than they had where m is large") {
  for (const int count : {2, 10, 100}) {
    ContactDetector detector(slab, {.radius = 0.1});
    RigidBody body({.mass = 10}, Pose(), {}, {}, {{true, true, true, false, false, false}});
    std::vector<Vec3d> x_t0, x_t1, velocity;
    for (int k = 0; k < count; ++k) x_t0.push_back({0.05 * k - 2.5, 0, 0.7}), x_t1.push_back({0.05 * k - 2.5, 0, 0.5}), velocity.push_back({0, 0, -1});
    // At 1 m/s a way of 0.1 m takes half of this step: (x_t1 - x_t0)/dt is half of the velocity.
    const Motion motion = body.advance(0.2);
    respond(detector.detect(motion, x_t0, x_t1), motion, body, {x_t0, x_t1, velocity, 1.0});
    const double given = 0.5 * count;                                                    // [N s] each lost half of its velocity
    CHECK(body.kinetic_energy() == fixtures::relative(given * given / (2 * 10), 1e-9));  // the offset of 1e-11 m of 0.1
    if (count == 100) CHECK(body.kinetic_energy() > 0.5 * count);                        // of the points before
  }
}

TEST_CASE("promises: moments are about the centre of mass of the rigid body that is given, which for a motion of one's own is made for the step") {
  ContactDetector detector(share(Surface(make_box({.size = {1, 1, 1}}))), {.radius = 0.1});
  const Vec3d centre{0.2, 0, 0};
  const Motion motion{Pose({10, 0, 0}), Pose({10, 0, 0}), 1, centre};
  const auto sum = [&](const RigidBody& body) {
    const std::vector<Vec3d> x_t0{{10.2, 0, 2}};
    std::vector<Vec3d> x_t1{{10.2, 0, 0.5}}, velocity{{0, 0, -1.5}};
    return respond_without_body(detector.detect(motion, x_t0, x_t1), motion, body, {x_t0, x_t1, velocity, 1.0});
  };
  const ContactSum about_centre = sum(RigidBody({.mass = 1, .centre_of_mass = centre}, motion.t1, {}, {}, {}));
  CHECK(about_centre.angular_impulse.y == fixtures::absolute(0, 1e-14, "N m s"));  // the push is along the line through the centre; rounding of 10 m
  const ContactSum about_origin = sum(RigidBody({.mass = 1}, Pose(), {}, {}, {}));
  CHECK(about_origin.angular_impulse.y == fixtures::relative(-10.2 * about_origin.impulse.z, 1e-12));
}

TEST_CASE("promises: a ball that begins in front of an open surface, nearer than its radius, is listed, and is taken for one that came round its edge") {
  ContactDetector detector(Surface(square(), {.orientation = Orientation::normals}), {.radius = 0.1});
  const std::vector<Vec3d> overlapping{{0.3, 0.2, 0.09}}, through{{0.3, 0.2, -0.01}};
  CHECK(detector.points_inside(Pose(), overlapping) == std::vector<std::size_t>{0});
  CHECK(detector.detect(still, overlapping, overlapping).empty());
  CHECK(detector.swept().entered_inside() == 1);
  CHECK(detector.detect(still, overlapping, through).size() == 1);  // its centre crosses
}
