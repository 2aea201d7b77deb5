// The C interface against the C++ interface, which shares no arrays, handles or views with it in these tests.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "fccda/api/contact_detector.hpp"
#include "fccda/c/scenes.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"

using namespace c_scenes;

namespace {

constexpr double dt = 0.01, radius = 0.02, friction = 0.3;
const Panels ring = fixtures::torus(1, 0.4, 16, 8, 1);

fccda_body_properties c_ring() {
  fccda_body_properties body = fccda_fixed_body(4);
  body.centre_of_mass[0] = 0.05;
  body.inertia[0] = 2, body.inertia[4] = 2.5, body.inertia[8] = 4, body.inertia[1] = body.inertia[3] = 0.1;
  body.added_mass[2] = 0.5;
  body.pose.position[2] = 0.1;
  body.velocity[2] = 0.4;
  body.angular_velocity[1] = 0.7;
  std::fill(body.is_free, body.is_free + 6, 1);
  return body;
}

RigidBody cpp_ring() {
  return RigidBody({.mass = 4, .centre_of_mass = {0.05, 0, 0}, .inertia = {{{2, 0.1, 0}, {0.1, 2.5, 0}, {0, 0, 4}}}, .added_mass = {0, 0, 0.5}},
                   Pose({0, 0, 0.1}), {0, 0, 0.4}, {0, 0.7, 0}, {{true, true, true, true, true, true}});
}

struct CRun {
  fccda_surface* surface = surface_of(ring);
  fccda_detector* detector = nullptr;
  fccda_body* body = nullptr;
  fccda_motion motion{};

  CRun() {
    const fccda_body_properties properties = c_ring();
    REQUIRE(fccda_detector_create(surface, radius, &detector) == FCCDA_OK);
    REQUIRE(fccda_body_create(&properties, &body) == FCCDA_OK);
    fccda_surface_destroy(surface);  // the detector keeps what it needs
  }
  CRun(const CRun&) = delete;
  ~CRun() { fccda_detector_destroy(detector), fccda_body_destroy(body); }

  std::vector<fccda_contact> contacts() const {
    const fccda_contact* first = nullptr;
    std::size_t number = 0;
    CHECK(fccda_detector_contacts(detector, &first, &number) == FCCDA_OK);
    return {first, first + number};
  }
  fccda_body_state state() const {
    fccda_body_state state{};
    CHECK(fccda_body_state_of(body, &state) == FCCDA_OK);
    return state;
  }
};

bool same(const RigidBody& a, const CRun& b) {
  const fccda_body_state state = b.state();
  fccda_pose pose{};
  double energy = 0;
  fccda_body_pose(b.body, &pose);
  fccda_body_kinetic_energy(b.body, &energy);
  const Quaternion& q = a.pose().attitude();
  return a.position_of_com() == as_vector(state.centre_of_mass) && a.velocity() == as_vector(state.velocity) &&
         a.angular_velocity() == as_vector(state.angular_velocity) && q.w == state.attitude[0] && q.x == state.attitude[1] && q.y == state.attitude[2] &&
         q.z == state.attitude[3] && a.constraint_work() == state.constraint_work && a.pose().position() == as_vector(pose.position) &&
         q.w == pose.attitude[0] && a.kinetic_energy() == energy;
}

/// Many steps with both; all that can be read is compared in each.
template <class Number>
void compare(const Layout& layout, bool with_radii, bool with_body) {
  const std::string where = layout.name;
  CAPTURE(where);
  CAPTURE(sizeof(Number));
  CAPTURE(with_radii);
  CAPTURE(with_body);
  Cloud<Number> ours(layout, {-1.4, -1.4, 0.7}, {1.4, 1.4, 1.5}), theirs = ours;
  ContactDetector detector(Surface(ring), {.radius = radius});
  RigidBody body = cpp_ring();
  CRun c;
  const fccda_points points = theirs.c_points(with_radii);
  std::size_t all = 0, sliding = 0;
  for (int step = 0; step < 70; ++step) {
    ours.move(dt), theirs.move(dt);
    const Motion motion = body.advance(dt);
    REQUIRE(fccda_body_advance(c.body, dt, &c.motion) == FCCDA_OK);
    const PointArrays arrays = ours.points();
    const std::vector<Contact> contacts =
        with_radii ? detector.detect(motion, arrays.x_t0, arrays.x_t1, ours.of_each(layout.radius)) : detector.detect(motion, arrays.x_t0, arrays.x_t1);
    const ContactSum sum = with_body ? respond(contacts, motion, body, arrays, friction) : respond_without_body(contacts, motion, body, arrays, friction);

    std::size_t number = 0;
    fccda_contact_sum c_sum{};
    REQUIRE(fccda_detect(c.detector, &c.motion, &points, &number) == FCCDA_OK);
    REQUIRE(number == contacts.size());
    const std::vector<fccda_contact> c_contacts = c.contacts();
    CHECK(std::equal(contacts.begin(), contacts.end(), c_contacts.begin(), c_contacts.end(),
                     [](const Contact& a, const fccda_contact& b) { return c_scenes::same(a, b); }));
    REQUIRE(fccda_respond(c.detector, &c.motion, &points, friction, with_body ? c.body : nullptr, &c_sum) == FCCDA_OK);
    if (with_body) {
      CHECK(c_scenes::same(sum, c_sum));
    } else {
      CHECK(sum.impulse == as_vector(c_sum.impulse));
      // the centre of the motion is where the body's centre of mass is, up to rounding
      CHECK(norm(sum.angular_impulse - as_vector(c_sum.angular_impulse)) == fixtures::absolute(0, 1e-14 * (1 + norm(sum.impulse)), "N m s"));
      body.add_impulse(as_vector(c_sum.impulse), as_vector(c_sum.angular_impulse));
      CHECK(fccda_body_add_impulse(c.body, c_sum.impulse, c_sum.angular_impulse) == FCCDA_OK);
    }
    CHECK(same(body, c));
    REQUIRE(std::memcmp(ours.numbers.data(), theirs.numbers.data(), ours.numbers.size() * sizeof(Number)) == 0);
    all += contacts.size();
    sliding += static_cast<std::size_t>(std::ranges::count_if(contacts, [](const Contact& contact) { return norm(contact.normal_t0) > 0; }));
  }
  CHECK(all > 1000);
  CHECK(sliding > 100);
}

}  // namespace

TEST_CASE("C interface: contacts, relocated points, velocities, impulses and the body are those of C++ bit for bit, for every layout of arrays") {
  for (const Layout& layout : layouts())
    for (const bool with_radii : {false, true}) {
      compare<double>(layout, with_radii, true);
      compare<float>(layout, with_radii, true);
    }
}

TEST_CASE("C interface: without a body the impulse is that of C++, and the moment is about the centre of the motion") {
  compare<double>(layouts()[0], false, false);
  compare<float>(layouts()[2], true, false);
}

TEST_CASE("C interface: points inside are those of C++, with the radius of the detector or one for each") {
  Cloud<double> cloud(layouts()[2], {-1.6, -1.6, -0.5}, {1.6, 1.6, 0.5});
  CRun c;
  const ContactDetector detector(Surface(ring), {.radius = radius});
  const Pose pose({0.1, 0, 0.2}, Quaternion::from_rotation({0.3, 0.1, 0}));
  const Quaternion& q = pose.attitude();
  const fccda_pose c_pose{{0.1, 0, 0.2}, {q.w, q.x, q.y, q.z}};
  const fccda_vectors x = cloud.c_vectors(cloud.layout.x_t1);
  const fccda_numbers radii = cloud.c_numbers(cloud.layout.radius), unset = fccda_unset();
  const auto inside = [&](const fccda_numbers* given) {
    const std::int64_t* first = nullptr;
    std::size_t number = 0;
    CHECK(fccda_detector_points_inside(c.detector, &c_pose, &x, given, &first, &number) == FCCDA_OK);
    return std::vector<std::size_t>(first, first + number);
  };
  const std::vector<std::size_t> expected = detector.points_inside(pose, cloud.vectors(cloud.layout.x_t1));
  const std::vector<std::size_t> expected_of_balls = detector.points_inside(pose, cloud.vectors(cloud.layout.x_t1), cloud.of_each(cloud.layout.radius));
  CHECK(expected.size() > 20);
  CHECK(expected != expected_of_balls);
  CHECK(inside(nullptr) == expected);
  CHECK(inside(&unset) == expected);
  CHECK(inside(&radii) == expected_of_balls);
}

TEST_CASE("C interface: the response is to the contacts that are kept, and to no others") {
  Cloud<double> whole(layouts()[0], {-1.2, -1.2, 0.45}, {1.2, 1.2, 0.6}), part = whole;
  CRun first, second;
  whole.move(dt), part.move(dt);
  const Cloud<double> unchanged = part;
  const fccda_points of_whole = whole.c_points(false), of_part = part.c_points(false);
  for (CRun* each : {&first, &second}) REQUIRE(fccda_body_advance(each->body, dt, &each->motion) == FCCDA_OK);
  std::size_t number = 0;
  CHECK(fccda_detect(first.detector, &first.motion, &of_whole, nullptr) == FCCDA_OK);
  CHECK(fccda_detect(second.detector, &second.motion, &of_part, &number) == FCCDA_OK);
  REQUIRE(number > 10);
  const std::vector<fccda_contact> contacts = second.contacts();
  const std::vector<std::int64_t> kept{1, 4, 7};
  CHECK(fccda_detector_keep(second.detector, kept.data(), kept.size()) == FCCDA_OK);
  CHECK(second.contacts().size() == 3);
  fccda_contact_sum sum{};
  CHECK(fccda_respond(first.detector, &first.motion, &of_whole, friction, nullptr, nullptr) == FCCDA_OK);
  CHECK(fccda_respond(second.detector, &second.motion, &of_part, friction, nullptr, &sum) == FCCDA_OK);
  CHECK(sum.contacts == 3);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_kept = std::ranges::any_of(kept, [&](std::int64_t k) { return contacts[std::size_t(k)].point == std::int64_t(i); });
    const Cloud<double>& expected = is_kept ? whole : unchanged;
    CHECK(std::equal(&part.numbers[3 * (count + i)], &part.numbers[3 * (count + i)] + 3, &expected.numbers[3 * (count + i)]));
  }
}

TEST_CASE("C interface: a run that is stopped and resumed from the state of detector and body continues bitwise") {
  const auto step = [](CRun& run, Cloud<double>& cloud) {
    cloud.move(dt);
    const fccda_points points = cloud.c_points(false);
    CHECK(fccda_body_advance(run.body, dt, &run.motion) == FCCDA_OK);
    CHECK(fccda_detect(run.detector, &run.motion, &points, nullptr) == FCCDA_OK);
    CHECK(fccda_respond(run.detector, &run.motion, &points, friction, run.body, nullptr) == FCCDA_OK);
  };
  Cloud<double> cloud(layouts()[0], {-1.4, -1.4, 0.7}, {1.4, 1.4, 1.5});
  CRun whole;
  for (int k = 0; k < 30; ++k) step(whole, cloud);
  Cloud<double> other = cloud;
  CRun resumed;
  const std::int64_t* numbers = nullptr;
  std::size_t length = 0;
  CHECK(fccda_detector_state(whole.detector, &numbers, &length) == FCCDA_OK);
  CHECK(fccda_detector_resume(resumed.detector, numbers, length) == FCCDA_OK);
  const fccda_body_state state = whole.state();
  CHECK(fccda_body_resume(resumed.body, &state) == FCCDA_OK);
  for (int k = 0; k < 30; ++k) step(whole, cloud), step(resumed, other);
  CHECK(cloud.numbers == other.numbers);
  const fccda_body_state a = whole.state(), b = resumed.state();
  CHECK(std::memcmp(&a, &b, sizeof a) == 0);
}

TEST_CASE("C interface: a point that was displaced between two steps is found where it was put, once that is reported") {
  for (const bool all : {false, true}) {
    CAPTURE(all);
    std::vector<double> x_t0{5, 0, 0}, x_t1{5, 0, 0}, v(3);
    CRun c;
    fccda_motion rest{fccda_no_pose(), fccda_no_pose(), {0, 0, 0}, dt};
    const fccda_points points{fccda_xyz(x_t0.data(), 1), fccda_xyz(x_t1.data(), 1), fccda_xyz(v.data(), 1), fccda_one(1), fccda_unset()};
    std::size_t number = 0;
    CHECK(fccda_detect(c.detector, &rest, &points, &number) == FCCDA_OK);
    CHECK(number == 0);
    x_t0 = x_t1 = {1, 0, 0.1};  // inside the ring
    CHECK((all ? fccda_detector_points_changed(c.detector) : fccda_detector_moved(c.detector, 0)) == FCCDA_OK);
    CHECK(fccda_detect(c.detector, &rest, &points, &number) == FCCDA_OK);
    CHECK(number == 1);
  }
}
