#include "fccda/api/respond_arrays.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

RigidBody free_body(double mass) { return {{.mass = mass}, Pose(), {}, {}, {{true, true, true, false, false, false}}}; }

}  // namespace

TEST_CASE("plain response: a point in contact is relocated with the corresponding velocity, and the body receives its lost momentum") {
  RigidBody body = free_body(4);
  const Motion motion = body.advance(0.5);
  const std::vector<Contact> contacts{{.point = 1, .normal = {0, 0, 1}, .relocation = {1, 1, 1}}};
  const std::vector<double> x_t0{9, 9, 9, 1, 1, 2};
  std::vector<double> x_t1{8, 8, 8, 1, 1, 0}, velocity{-2, -2, -2, 0, 0, -4};
  const ContactSum sum = respond(contacts, motion, body, {x_t0, x_t1, velocity, 3.0});
  // by hand: v̄ = (1 - 2)/0.5 = -2, J = -3 (-2 - -4) = -6, V = -6/4
  CHECK(x_t1 == std::vector<double>{8, 8, 8, 1, 1, 1});
  CHECK(velocity == std::vector<double>{-2, -2, -2, 0, 0, -2});
  CHECK(sum.impulse == Vec3d{0, 0, -6});
  CHECK(sum.contacts == 1);
  CHECK(body.velocity() == Vec3d{0, 0, -1.5});

  const std::vector<double> masses{100, 3};
  RigidBody same = free_body(4);
  velocity[5] = -4, x_t1[5] = 0;
  CHECK(respond(contacts, same.advance(0.5), same, {x_t0, x_t1, velocity, masses}).impulse == sum.impulse);
}

TEST_CASE("plain response: arrays of different length and steps of no duration are rejected") {
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

TEST_CASE("plain response: masses with a stride and arrays of floats give the same as contiguous doubles") {
  const std::vector<Contact> contacts{{.point = 1, .normal = {0, 0, 1}, .relocation = {1, 1, 1}}};
  RigidBody body = free_body(4);
  const std::vector<float> x_t0{9, 9, 9, 1, 1, 2}, padded{100, 0, 3, 0};
  std::vector<float> x_t1{8, 8, 8, 1, 1, 0}, velocity{-2, -2, -2, 0, 0, -4};
  const ContactSum sum = respond(contacts, body.advance(0.5), body, {x_t0, x_t1, velocity, {padded.data(), 2, 2}});
  CHECK(x_t1 == std::vector<float>{8, 8, 8, 1, 1, 1});
  CHECK(velocity == std::vector<float>{-2, -2, -2, 0, 0, -2});
  CHECK(sum.impulse == Vec3d{0, 0, -6});
}

TEST_CASE("plain response: without the body it returns the body's impulse, and the sum over several sets of points, applied once, equals that of one call") {
  const std::vector<Contact> contacts{{.point = 0, .normal = {0, 0, 1}, .relocation = {1, 0, 1}}, {.point = 1, .normal = {0, 0, 1}, .relocation = {0, 1, 1}}};
  const std::vector<Vec3d> x_t0{{1, 0, 2}, {0, 1, 2}}, velocity{{0, 0, -4}, {0, 0, -6}};
  const auto body = [] { return RigidBody({.mass = 4, .inertia = Mat3::identity()}, Pose(), {}, {}, {{true, true, true, true, true, true}}); };
  RigidBody whole = body(), parts = body();
  const Motion motion{Pose(), Pose(), 0.5};
  std::vector<Vec3d> x = x_t0, v = velocity;
  respond(contacts, motion, whole, {x_t0, x, v, 3.0}, 0.1);
  std::vector<Vec3d> again = x_t0, w = velocity;
  ContactSum sum;
  for (const Contact& contact : contacts) sum += respond_without_body({&contact, 1}, motion, parts, {x_t0, again, w, 3.0}, 0.1);
  CHECK(parts.velocity() == Vec3d{});
  CHECK(sum.contacts == 2);
  parts.add_impulse(sum.impulse, sum.angular_impulse);
  CHECK((again == x && w == v));
  CHECK((parts.velocity() == whole.velocity() && parts.angular_velocity() == whole.angular_velocity()));
}

TEST_CASE("plain response: friction that is negative or not a number, masses and velocities that are not finite are rejected without effect") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::vector<Contact> contacts{{.point = 0, .normal = {0, 0, 1}, .relocation = {0, 0, 1}}};
  const std::vector<Vec3d> x_t0{{0, 0, 2}};
  RigidBody body = free_body(4);
  const Motion motion = body.advance(0.5);
  const auto refused = [&](double mass, const Vec3d& speed, double friction, const std::string& sentence) {
    std::vector<Vec3d> x{{0, 0, 0}}, v{speed};
    CHECK_THROWS_WITH_AS(respond(contacts, motion, body, {x_t0, x, v, mass}, friction), sentence.c_str(), InputError);
    CHECK(x[0] == Vec3d{});
    CHECK(body.velocity() == Vec3d{});
  };
  refused(1, {}, -1, "contact: the friction coefficient is -1, but it must be a finite number of at least 0.");
  refused(1, {}, nan, "contact: the friction coefficient is nan, but it must be a finite number of at least 0.");
  refused(1, {}, infinity, "contact: the friction coefficient is inf, but it must be a finite number of at least 0.");
  refused(-1, {}, 0, "contact: the mass of point 0 is -1 kg, but it must be a finite number of at least 0.");
  refused(nan, {}, 0, "contact: the mass of point 0 is nan kg, but it must be a finite number of at least 0.");
  std::vector<Vec3d> x{{0, 0, 0}}, v{{0, 0, -1e300}};
  CHECK_THROWS_AS(respond(contacts, motion, body, {x_t0, x, v, 1e300}), InputError);  // whose impulse is not finite
  CHECK(x[0] == Vec3d{});
  CHECK(v[0] == Vec3d{0, 0, -1e300});
  v[0].z = -4;
  const std::vector<Vec3d> nowhere{{0, 0, nan}};
  const auto unstable = [](const std::string& what) {
    return "contact: the " + what + ", which is not finite; the solver has become unstable, use a shorter step.";
  };
  CHECK_THROWS_WITH_AS(respond(contacts, motion, body, {nowhere, x, v, 1.0}), unstable("position at t0 of point 0 is (0, 0, nan)").c_str(), RunError);
  std::vector<Vec3d> too_fast{{0, infinity, 0}};
  CHECK_THROWS_WITH_AS(respond(contacts, motion, body, {x_t0, x, too_fast, 1.0}), unstable("velocity of point 0 is (0, inf, 0)").c_str(), RunError);
  CHECK(x[0] == Vec3d{});
  CHECK(v[0] == Vec3d{0, 0, -4});
  Motion astray = motion;
  astray.t1 = Pose({0, nan, 0});
  CHECK_THROWS_AS(respond(contacts, astray, body, {x_t0, x, v, 1.0}), InputError);
  const std::vector<Contact> of_nobody{{.point = 1}};
  CHECK_THROWS_AS(respond(of_nobody, motion, body, {x_t0, x, v, 1.0}), InputError);
}

TEST_CASE("plain response: two contacts of one point, as of two detectors, and contacts in another order are refused, and nothing is changed") {
  RigidBody body = free_body(1);
  const Motion motion = body.advance(1);
  const std::vector<Vec3d> x_t0{{0, 0, 1}, {1, 0, 1}};
  std::vector<Vec3d> x{{0, 0, 0.5}, {1, 0, 0.5}}, v{{0, 0, -0.5}, {0, 0, -0.5}};
  const Contact first{.point = 0, .normal = {0, 0, 1}, .relocation = {0, 0, 0.6}}, second{.point = 1, .normal = {0, 0, 1}, .relocation = {1, 0, 0.6}};
  const auto refusal = [&](const std::vector<Contact>& contacts) {
    std::string sentence;
    try {
      respond(contacts, motion, body, {x_t0, x, v, 1.0});
    } catch (const InputError& error) {
      sentence = error.what();
    }
    CHECK((v[0].z == -0.5 && v[1].z == -0.5 && x[0].z == 0.5 && x[1].z == 0.5));
    CHECK(body.velocity() == Vec3d{});
    return sentence;
  };
  const std::string why = ", but each point may have one contact only, in ascending order; respond to the contacts of each detector by themselves.";
  CHECK(refusal({first, first}) == "contact: a contact of point 0 follows one of point 0" + why);
  CHECK(refusal({second, first}) == "contact: a contact of point 0 follows one of point 1" + why);
  respond(std::vector<Contact>{first, second}, motion, body, {x_t0, x, v, 1.0});
  CHECK(v[0].z + v[1].z + body.velocity().z == fixtures::relative(-1, 1e-15));  // momentum of two points of 1 kg
}
