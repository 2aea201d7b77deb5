// Friction on points near other panels, and points in very narrow gaps.
#include <doctest/doctest.h>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/detect/half_spaces.hpp"
#include "fccda/detect/scene.hpp"
#include "fccda/evidence/truth.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr double dt = 0.01, gravity = 9.81;

/// Two panels that meet along y, open at the top, front within: walls z = |x| height/width.
Surface valley(double width, double height) {
  Panels p;
  p.vertices = {{-width, -1, height}, {0, -1, 0}, {0, 1, 0}, {-width, 1, height}, {width, -1, height}, {width, 1, height}};
  p.add_quad(0, 1, 2, 3);
  p.add_quad(1, 4, 5, 2);
  return Surface(p, {.orientation = Orientation::normals});
}

struct Fall {
  std::vector<Vec3d> x_t0, x, v;
  RigidBody body{{.mass = 1}, Pose(), {}, {}, {}};
  std::vector<Contact> contacts;

  void step(ContactDetector& detector, double friction) {
    x_t0 = x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      v[i].z -= gravity * dt;
      x[i] += dt * v[i];
    }
    const Motion motion = body.advance(dt);
    contacts = detector.detect(motion, x_t0, x);
    respond(contacts, motion, body, {.x_t0 = x_t0, .x_t1 = x, .velocity = v, .mass = 1.0}, friction);
  }
};

}  // namespace

TEST_CASE("sliding: friction moves no point through the other panel of a valley, and brings it to rest there") {
  const double slope = 0.5;  // the walls are z = |x|/2
  for (const double friction : {0.0, 0.2, 0.45, 0.6, 1.0}) {
    CAPTURE(friction);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    ContactDetector detector(valley(1, slope));
    Fall fall;
    for (int i = 0; i < 100; ++i) {
      fall.x.push_back({0.6 * unit(random), 0.3 * unit(random), 0.6});
      fall.v.push_back({0.5 * unit(random), 0, -1});
    }
    fall.x[0] = {.3, 0, .6}, fall.v[0] = {.5, 0, -1};
    std::size_t behind = 0;
    for (int step = 0; step < 400; ++step) {
      fall.step(detector, friction);
      for (const Vec3d& x : fall.x) behind += x.z < slope * std::fabs(x.x);
    }
    CHECK(behind == 0);
    double fastest = 0;
    for (const Vec3d& v : fall.v) fastest = fixtures::larger(fastest, norm(v));
    if (friction >= 0.2) CHECK(fastest < 1e-9);  // friction and the corner have removed all of some metres per second
  }
}

TEST_CASE("sliding: friction moves no point through a closed folded sheet of thickness 1e-4") {
  // z = |x|/2, and the same 1e-4 lower
  Panels sheet;
  for (const double y : {-1.0, 1.0})
    for (const double down : {0.0, 1e-4})
      for (const double x : {-1.0, 0.0, 1.0}) sheet.vertices.push_back({x, y, 0.5 * std::fabs(x) - down});
  const auto quad = [&](int a, int b, int c, int d) { sheet.add_quad(a, b, c, d); };
  for (const int k : {0, 1}) {
    quad(k, k + 1, k + 7, k + 6), quad(k + 3, k + 9, k + 10, k + 4);  // top, bottom
    quad(k, k + 3, k + 4, k + 1), quad(k + 6, k + 7, k + 10, k + 9);  // ends
  }
  quad(0, 6, 9, 3), quad(2, 5, 11, 8);
  const Surface surface(sheet);
  REQUIRE(surface.is_closed());
  for (const double r : {0.0, 0.01}) {
    ContactDetector detector(surface, {.radius = r});
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    Fall fall;
    for (int i = 0; i < 300; ++i) {
      fall.x.push_back({0.6 * unit(random), 0.3 * unit(random), 0.6});
      fall.v.push_back({0.5 * unit(random), 0, -1});
    }
    std::size_t below = 0;
    for (int step = 0; step < 150; ++step) {
      fall.step(detector, 0.2);
      for (const Vec3d& x : fall.x) below += x.z < 0.5 * std::fabs(x.x) + r;  // along z, where the distance is even smaller
    }
    CHECK(below == 0);
  }
}

TEST_CASE("sliding: without friction no point is lost in a crevice, however sharp") {
  for (const double degrees : {30.0, 4.0, 0.5, 0.05}) {
    CAPTURE(degrees);
    const double width = std::tan(0.5 * degrees * std::numbers::pi / 180);
    ContactDetector detector(valley(width, 1));
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    Fall fall;
    for (int i = 0; i < 300; ++i) {
      const double height = 0.2 + 0.7 * unit(random);
      fall.x.push_back({0.99 * width * height * (2 * unit(random) - 1), 0.9 * (2 * unit(random) - 1), height});
      fall.v.push_back({});
    }
    std::size_t behind = 0;
    for (int step = 0; step < 400; ++step) {
      fall.step(detector, 0);
      for (const Vec3d& x : fall.x) behind += x.z * width < std::fabs(x.x);
    }
    CHECK(behind == 0);
  }
}

TEST_CASE("sliding: in a channel friction along it acts in full, while the walls leave no clearance across") {
  // pressed into the right-angled edge of a valley, sliding along it: the wall evaluated last applies Coulomb friction for its normal impulse
  ContactDetector detector(valley(1, 1), {.radius = 0.05});
  Fall fall;
  fall.x = {{0, -0.8, 0.05 * std::sqrt(2.0)}}, fall.v = {{0, 0.5, 0}};
  double last = 0.5;
  for (int step = 0; step < 20; ++step) {
    fall.step(detector, 0.1);
    REQUIRE(fall.contacts.size() == 1);
    const double lost = last - fall.v[0].y;
    last = fall.v[0].y;
    CHECK(lost > 0.05 * gravity * dt);
    CHECK(lost <= 0.1 * gravity * dt * std::sqrt(2.0));  // µ times the normal impulse of two walls
    CHECK(std::fabs(fall.x[0].x) < 1e-9);
  }
}

TEST_CASE("sliding: friction never exceeds Coulomb's bound and never accelerates sliding, in concave regions too") {
  const auto surface = fixtures::surface_of(fixtures::hull());
  const fixtures::Soup soup(*surface);
  const double friction = 0.6;
  std::size_t obstructed = 0;
  for (const double r : {0.0, 0.02}) {
    const fixtures::Shots shots(soup, r, 0.2, 600, 10);
    Swept detector(surface, Unbounded{}, r);
    const fixtures::TestPoints points = fixtures::points_on(shots.paths);
    const Motion motion = fixtures::at_rest();
    for (const Contact& contact : fixtures::detect(detector, points, motion)) {
      const Path& path = shots.paths[contact.point];
      const Vec3d velocity = path.end - path.start;  // dt is 1
      const Resolved smooth = resolved(contact, path.start, velocity, motion, 0), rough = resolved(contact, path.start, velocity, motion, friction);
      const Vec3d change = rough.velocity - smooth.velocity;
      CHECK(norm(change) <= friction * std::max(0.0, dot(smooth.velocity - velocity, contact.normal)) * (1 + 1e-12));
      CHECK(norm(rough.velocity) <= norm(smooth.velocity) * (1 + 1e-12));
      CHECK(norm(rough.position - path.start - rough.velocity) < 1e-12);  // eq. 8
      CHECK(soup.distance(rough.position) > r);
      CHECK_FALSE(soup.inside(rough.position));
      const Vec3d relative = smooth.velocity - dot(smooth.velocity, contact.normal) * contact.normal;
      const double pushed = std::max(0.0, dot(smooth.velocity - velocity, contact.normal));
      obstructed += norm(change) < 0.999 * std::min(friction * pushed, norm(relative));
    }
  }
  CHECK(obstructed > 10);  // the scene exercises the obstruction
}

TEST_CASE("sliding: the nearest point in front of planes lies on one, two or three of them") {
  HalfSpaces<5> corner;
  corner.add({1, 0, 0}, 1), corner.add({0, 1, 0}, 2), corner.add({0, 0, 1}, 3), corner.add(normalised(Vec3d{1, 1, 0}), 0);
  CHECK(norm(corner.nearest({5, 6, 7}, 0).value() - Vec3d{5, 6, 7}) < 1e-15);
  CHECK(norm(corner.nearest({0, 6, 7}, 0).value() - Vec3d{1, 6, 7}) < 1e-15);
  CHECK(norm(corner.nearest({0, 0, 7}, 0).value() - Vec3d{1, 2, 7}) < 1e-15);
  CHECK(norm(corner.nearest({0, 0, 0}, 0).value() - Vec3d{1, 2, 3}) < 1e-15);
  corner.add({-1, 0, 0}, -0.5);  // x <= 0.5 and x >= 1
  CHECK_FALSE(corner.nearest({0, 0, 0}, 0).has_value());
}

TEST_CASE("first contact: for a ball at a shallow angle it is the time and position at which the ball meets the plate") {
  const auto plate = fixtures::surface_of(make_box({.size = {4, 4, 0.2}, .edge_length = 4}));  // top at z = 0.1
  const double r = 0.01;
  for (const double degrees : {0.1, 1.0, 3.0, 5.0, 30.0, 90.0}) {
    CAPTURE(degrees);
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3d way{std::cos(angle), 0, -std::sin(angle)}, middle{0.3, 0.2, 0.1 + r};
    Swept detector(plate, Unbounded{}, r);
    const std::vector<Contact> contacts = fixtures::detect(detector, fixtures::points_on({{middle - 0.5 * way, middle + 0.5 * way}}));
    REQUIRE(contacts.size() == 1);
    // the tolerated offset of 4e-12 is 2.3e-9 of the path at 0.1°
    CHECK(contacts[0].time_fraction == fixtures::absolute(0.5, 1e-8, "1"));
    CHECK(norm(contacts[0].hit - Vec3d{0.3, 0.2, 0.1}) < 1e-8);
  }
}

TEST_CASE("first contact: on faces, edges and vertices of any body it is where the distance first falls to the radius") {
  const double r = 0.02;
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    const fixtures::Shots shots(soup, r, 0.1, 200, 11);
    Swept detector(surface, Unbounded{}, r);
    for (const Contact& contact : fixtures::detect(detector, fixtures::points_on(shots.paths))) {
      const Path& path = shots.paths[contact.point];
      const double f = contact.time_fraction;
      CHECK(soup.distance(path.at(f)) == fixtures::absolute(r, 1e-10, "m"));
      CHECK(norm(path.at(f) - contact.hit) == fixtures::absolute(r, 1e-10, "m"));
      if (f > 0) CHECK(soup.distance(Path{path.start, path.at(f * (1 - 1e-6))}) > r);  // and not before
    }
  }
}

TEST_CASE("crossing: a path in the plane of a panel that passes beside it is not contact, in any orientation") {
  // In the plane of a plate's top face, beside it in all directions. In rotated frames the heights are rounding errors.
  const Panels plate = make_box({.size = {1, 1, 0.1}, .edge_length = 1});
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t contacts = 0, paths_tried = 0;
  for (int turn = 0; turn < 200; ++turn) {
    const Vec3d rotation = turn == 0 ? Vec3d{} : 3 * fixtures::random_direction(random);
    const auto surface = fixtures::surface_of(fixtures::moved(plate, [&](const Vec3d& p) { return evidence::turned(p, rotation); }));
    std::vector<Path> paths;
    while (paths.size() < 50) {
      const Vec3d a{2 * unit(random), 2 * unit(random), 0.05}, b{2 * unit(random), 2 * unit(random), 0.05};
      bool beside = true;  // all of it at least 0.05 from the square
      for (int k = 0; k <= 100 && beside; ++k) {
        const Vec3d p = a + (0.01 * k) * (b - a);
        beside = std::max(std::fabs(p.x), std::fabs(p.y)) > 0.55;
      }
      if (beside) paths.push_back({evidence::turned(a, rotation), evidence::turned(b, rotation)});
    }
    for (const double r : {0.0, 0.01}) {
      Swept detector(surface, Unbounded{}, r);
      contacts += fixtures::detect(detector, fixtures::points_on(paths)).size();
      paths_tried += paths.size();
    }
  }
  CHECK(contacts == 0);
  CHECK(paths_tried == 20'000);
}
