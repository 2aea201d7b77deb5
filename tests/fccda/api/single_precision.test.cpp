// Points in single precision: rest, sliding, and what is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "fccda/api/contact_detector.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace fccda;

namespace {

constexpr double g = 9.81;                  // [m/s²]
constexpr double o_of_coordinate = 2.4e-7;  // offset over largest coordinate

/// What a grain of 1 kg did on a surface.
struct Rest {
  double fastest = 0;   // [m/s] away from the surface
  double highest = 0;   // [m] beyond its contact radius
  double momentum = 0;  // [N s] of grain and impulse on the surface, less that of gravity
  double time = 0;      // [s]
  double along = 0;     // [m/s] velocity along x at the end
  std::size_t pushes = 0;
};

/// A grain above z = `top` at t = 0, which moves up at `speed`; `contact(x_t0, x_t1, v)` detects and responds.
template <class Contacts>
Rest rest_on(double top, double radius, double speed, const Vec3d& gravity, double dt, const Contacts& contact) {
  std::vector<float> x_t0, x_t1{0.1F, 0.2F, static_cast<float>(top + radius)}, v{0, 0, static_cast<float>(speed)};
  Rest rest;
  for (int step = 1; step <= 4000; ++step) {
    x_t0 = x_t1;
    for (std::size_t c = 0; c < 3; ++c) v[c] += static_cast<float>(dt * gravity[c]), x_t1[c] += static_cast<float>(dt * v[c]);
    const ContactSum sum = contact(x_t0, x_t1, v);
    rest.time = step * dt;
    rest.pushes += sum.contacts, rest.momentum += sum.impulse.z;
    rest.fastest = fixtures::larger(rest.fastest, v[2] - speed);
    rest.highest = fixtures::larger(rest.highest, x_t1[2] - (top + speed * rest.time) - radius);
  }
  rest.momentum += v[2] - speed - gravity.z * rest.time;
  rest.along = v[0];
  return rest;
}

Rest rest_on_box(double half_size, double radius, double speed, const Vec3d& gravity, double friction, double dt) {
  const Vec3d size{2 * half_size, 2 * half_size, 2 * half_size};
  ContactDetector detector(Surface(make_box({.size = size})), {.radius = radius});
  RigidBody body({.mass = 1}, Pose(), {0, 0, speed}, {}, {});
  return rest_on(half_size, radius, speed, gravity, dt, [&](std::vector<float>& x_t0, std::vector<float>& x_t1, std::vector<float>& v) {
    const Motion motion = body.advance(dt);
    return respond(detector.detect(motion, x_t0, x_t1), motion, body, {x_t0, x_t1, v, 1.0}, friction);
  });
}

template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("single precision: a grain at rest on a body, still or in motion, presses with its weight and is never thrown up") {
  struct Case {
    double half_size, radius, dt, speed;
  };
  for (const auto& [half_size, radius, dt, speed] :
       {Case{1, 0.01, 1e-4, 0}, Case{1, 0, 1e-4, 0}, Case{10, 0.1, 1e-5, 0}, Case{100, 1, 1e-4, 0}, Case{1, 0.01, 1e-4, 0.5}}) {
    const Rest rest = rest_on_box(half_size, radius, speed, {0, 0, -g}, 0, dt);
    // 2 o/dt would be 0.01 to 1 m/s; rounding of the relocation is 1e-15 of a coordinate in a step, and that of the velocity 1e-7 of it
    CHECK(rest.fastest == fixtures::absolute(0, 1e-13 * half_size / dt + 1e-7 * speed, "m/s"));
    // from o below to o above, and rounded by less than o
    const double o = o_of_coordinate * (half_size * std::sqrt(3) + speed * rest.time);
    CHECK(rest.highest == fixtures::absolute(0, 2 * o, "m"));
    // roundings of the velocity, 6e-8 of at most 0.5 m/s in each of 4000 steps
    CHECK(rest.momentum == fixtures::absolute(0, 4000 * 6e-8 * 0.5, "N s"));
    CHECK(rest.pushes > 5);
  }
}

TEST_CASE("single precision: a grain that slides on a body is braked by the friction of its weight") {
  const double slope = 0.5, friction = 0.3;  // [rad], [-]
  const Rest rest = rest_on_box(1, 0.01, 0, g * Vec3d{std::sin(slope), 0, -std::cos(slope)}, friction, 1e-4);
  // the last fall, of sqrt(4 g o) = 4e-3 m/s at most, is not braked yet
  CHECK(rest.along == fixtures::absolute(g * (std::sin(slope) - friction * std::cos(slope)) * rest.time, 4e-3 * friction, "m/s"));
  CHECK(rest.fastest == fixtures::absolute(0, 1e-9, "m/s"));  // as above
}

TEST_CASE("single precision: a grain at rest on a deforming surface is never thrown up") {
  Panels sheet;
  sheet.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
  sheet.add_quad(0, 1, 2, 3);
  for (const double vertex_mass : {prescribed_motion, 1e6}) {
    const auto surface = std::make_shared<DeformingSurface>(Surface(sheet, {.orientation = Orientation::normals}));
    DeformingContactDetector detector(surface, 0.01);
    std::vector<Vec3d> impulses(4);
    const double dt = 1e-5;
    const Rest rest = rest_on(0, 0.01, 0, {0, 0, -g}, dt, [&](std::vector<float>& x_t0, std::vector<float>& x_t1, std::vector<float>& v) {
      surface->move(sheet.vertices);
      return respond(detector.detect(x_t0, x_t1), dt, {x_t0, x_t1, v, 1.0}, 0, vertex_mass, impulses);
    });
    CHECK(rest.fastest == fixtures::absolute(0, 1e-9, "m/s"));  // 2 o/dt would be 0.5 m/s
    CHECK(rest.highest == fixtures::absolute(0, 2 * o_of_coordinate * 10, "m"));
    CHECK(rest.momentum == fixtures::absolute(0, 4000 * 6e-8 * 0.05, "N s"));
    CHECK(rest.pushes > 5);
  }
}

TEST_CASE("single precision: contacts carry the offset, and it is 0 in double precision") {
  ContactDetector detector(Surface(make_box({.size = {2, 2, 2}})), {.radius = 0.01});
  const Motion still{Pose(), Pose(), 1, {}};
  const std::vector<double> x_t0{0, 0, 2}, x_t1{0, 0, 1};
  const std::vector<Contact> in_double = detector.detect(still, x_t0, x_t1);
  REQUIRE(in_double.size() == 1);
  CHECK(in_double[0].offset == 0);
  const std::vector<float> f_t0{0, 0, 2}, f_t1{0, 0, 1};
  const std::vector<Contact> in_single = detector.detect(still, f_t0, f_t1);
  REQUIRE(in_single.size() == 1);
  CHECK(in_single[0].relocation.z - 1.01 == fixtures::relative(in_single[0].offset, 1e-6));  // differences of coordinates of 1, to 1e-16
  CHECK(in_single[0].offset == fixtures::relative(o_of_coordinate * std::sqrt(3), 0.01));    // 2.384e-7
}

TEST_CASE("single precision: where the offset is not small against the contact radius, or a surface without it, detection is refused in a sentence") {
  const auto box = share(Surface(make_box({.size = {10, 10, 10}})));
  const auto detect = [&](double distance, double radius, bool of_each, bool in_single) {
    ContactDetector detector(box, {.radius = of_each ? 1 : radius});
    const Pose far({distance, 0, 0});
    const std::vector<double> x{distance, 0, 6, distance, 1, 6}, radii{1, radius};
    const std::vector<float> f(x.begin(), x.end());
    const Motion still{far, far, 1, {}};
    return refusal([&] {
      if (in_single)
        of_each ? detector.detect(still, f, f, radii) : detector.detect(still, f, f);
      else
        of_each ? detector.detect(still, x, x, radii) : detector.detect(still, x, x);
    });
  };
  const std::string end = "; pass positions in double precision, or place the origin nearer to the surface.";
  const std::string begin = "contact: positions in single precision need an offset of 0.0238";
  const std::string middle = " m from the surface, which grows with its distance from the origin and must be at most a tenth of ";
  for (const bool of_each : {false, true}) {
    const std::string whose = of_each ? "the radius of point 1" : "the contact radius";
    CHECK(detect(1e5, 0.2, of_each, true).starts_with(begin));
    CHECK(detect(1e5, 0.2, of_each, true).ends_with(middle + whose + ", 0.2 m" + end));
    CHECK(detect(1e5, 0.25, of_each, true).empty());
    CHECK(detect(1e5, 0.2, of_each, false).empty());
    CHECK(detect(1e5, 0, of_each, true).empty());
    CHECK(detect(1e7, 0, of_each, true).ends_with(middle + "the surface's size, 10 m" + end));
    CHECK(detect(1e7, 0, of_each, false).empty());
  }

  Panels sheet;
  sheet.vertices = {{1e5, -10, 0}, {1e5 + 20, -10, 0}, {1e5 + 20, 10, 0}, {1e5, 10, 0}};
  sheet.add_quad(0, 1, 2, 3);
  const auto surface = std::make_shared<DeformingSurface>(Surface(sheet, {.orientation = Orientation::normals}));
  DeformingContactDetector detector(surface, 0.2);
  const std::vector<float> x{1e5F, 0, 1};
  const std::vector<double> radius{0.2};
  surface->move(sheet.vertices);
  CHECK(refusal([&] { detector.detect(x, x); }).ends_with(middle + "the contact radius, 0.2 m" + end));
  CHECK(refusal([&] { detector.detect(x, x, radius); }).ends_with(middle + "the radius of point 0, 0.2 m" + end));
  CHECK(refusal([&] { detector.detect(x, x, std::vector<double>{0.3}); }).empty());
}
