#include "fccda/api/contact_detector.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <type_traits>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/detect/scene.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr double ball = 0.01;  // [m]

bool same(const Contact& a, const Contact& b) {
  return a.point == b.point && a.panel == b.panel && a.time_fraction == b.time_fraction && a.hit == b.hit && a.normal == b.normal &&
         a.relocation == b.relocation && a.depth == b.depth;
}

bool same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& p, const Contact& q) { return same(p, q); });
}

RigidBody turning_hull() {
  const FreeDegrees all{{true, true, true, true, true, true}};
  return RigidBody({.mass = 30, .centre_of_mass = {0.3, 0.1, 0}, .inertia = Mat3::diagonal({2, 4, 5})}, Pose(), {0.3, 0.1, 0.5}, {0.5, -0.3, 1}, all);
}

/// A point cloud that falls on a hull, which rotates and moves into it.
struct Scene {
  std::shared_ptr<const Surface> surface = fixtures::surface_of(fixtures::hull());
  RigidBody hull = turning_hull();
  std::vector<Vec3d> x_t0, x_t1, velocity;
  std::vector<double> mass;
  static constexpr double dt = 2e-3;  // [s]

  explicit Scene(std::size_t points) {
    std::mt19937_64 random(5);
    for (std::size_t i = 0; i < points; ++i) {
      const Vec3d direction = fixtures::random_direction(random);
      x_t1.push_back((0.8 + 0.3 * std::fabs(fixtures::random_direction(random).x)) * direction);
      velocity.push_back(fixtures::random_direction(random) - 2.0 * direction);
      mass.push_back(0.01 + 1e-5 * double(i));
    }
  }

  Motion advance() {
    x_t0 = x_t1;
    for (std::size_t i = 0; i < x_t1.size(); ++i) x_t1[i] += dt * velocity[i];
    return hull.advance(dt);
  }

  Vec3d momentum() const {
    Vec3d sum = hull.momentum();
    for (std::size_t i = 0; i < mass.size(); ++i) sum += mass[i] * velocity[i];
    return sum;
  }
};

}  // namespace

TEST_CASE("plain call: contacts are bitwise identical to those with every point evaluated, with a rotating hull, for any number of threads") {
  std::size_t contacts_found = 0;
  for (const int count : {1, 3}) {
    const fixtures::Threads with_several(count);
    Scene scene(1000);
    ContactDetector detector(*scene.surface, {.radius = ball});
    for (int step = 0; step < 150; ++step) {
      const Motion motion = scene.advance();
      const std::vector<Contact> contacts = detector.detect(motion, scene.x_t0, scene.x_t1);
      Swept fresh(scene.surface, Unbounded{}, ball);  // without cache, so it evaluates every point
      std::vector<Contact> expected;
      fresh.detect(fixtures::TestPoints{scene.x_t0, scene.x_t1, {}, {}}, motion, 0, expected);
      REQUIRE(same(contacts, expected));
      contacts_found += contacts.size();
      respond(contacts, motion, scene.hull, {scene.x_t0, scene.x_t1, scene.velocity, scene.mass});
    }
    CHECK(detector.swept().effort().points_tested < 1000 * 150 / 4);  // and most points were skipped
  }
  CHECK(contacts_found > 1000);
}

TEST_CASE("plain call: no point is ever inside, by the winding number, and points and hull conserve momentum") {
  Scene scene(300);
  ContactDetector detector(*scene.surface, {.radius = ball});
  const Vec3d before = scene.momentum();
  double exchanged = 0;
  for (int step = 0; step < 150; ++step) {
    const Motion motion = scene.advance();
    const ContactSum sum =
        respond(detector.detect(motion, scene.x_t0, scene.x_t1), motion, scene.hull, {scene.x_t0, scene.x_t1, scene.velocity, scene.mass}, 0.3);
    exchanged += norm(sum.impulse);
  }
  REQUIRE(exchanged > 1);
  CHECK(norm(scene.momentum() - before) < 1e-12 * exchanged);  // rounding of 300 points over 150 steps
  const fixtures::Soup soup(*scene.surface);
  for (const Vec3d& x : scene.x_t1) CHECK_FALSE(soup.inside(scene.hull.pose().to_body(x)));
}

TEST_CASE("plain call: points may be appended, removed at the end and renumbered between steps") {
  Scene scene(200);
  ContactDetector detector(*scene.surface, {.radius = ball});
  std::size_t found = 0;
  const auto step_is_exact = [&] {
    const Motion motion = scene.advance();
    const std::vector<Contact> contacts = detector.detect(motion, scene.x_t0, scene.x_t1);
    const std::vector<Contact> expected = ContactDetector(*scene.surface, {.radius = ball}).detect(motion, scene.x_t0, scene.x_t1);
    found += contacts.size();
    respond(contacts, motion, scene.hull, {scene.x_t0, scene.x_t1, scene.velocity, scene.mass});
    return same(contacts, expected);
  };
  const Scene more(320);  // the same seed: its first 200 points start where those of the scene do
  for (int step = 0; step < 240; ++step) {
    if (step == 60) {
      scene.x_t1.insert(scene.x_t1.end(), more.x_t1.begin() + 200, more.x_t1.end());
      scene.velocity.insert(scene.velocity.end(), more.velocity.begin() + 200, more.velocity.end());
      scene.mass = more.mass;
    }
    if (step == 120) scene.x_t1.resize(150), scene.velocity.resize(150), scene.mass.resize(150);
    if (step == 180) {
      std::ranges::reverse(scene.x_t1), std::ranges::reverse(scene.velocity), std::ranges::reverse(scene.mass);
      detector.points_changed();
    }
    REQUIRE(step_is_exact());
  }
  CHECK(found > 100);
}

TEST_CASE("plain call: a point that was displaced in front of the surface is in contact there") {
  const Surface surface(make_box({.size = {1, 1, 1}, .edge_length = 1}));
  ContactDetector detector(surface, {.radius = ball});
  const Motion rest = fixtures::at_rest();
  CHECK(detector.detect(rest, std::vector<double>{0, 0, 50}, std::vector<double>{0, 0, 49}).empty());
  detector.moved(0);
  CHECK(detector.detect(rest, std::vector<double>{0, 0, 0.6}, std::vector<double>{0, 0, 0.4}).size() == 1);
}

TEST_CASE("plain call: a body moved by hand between two steps contacts points that it was far from") {
  const Surface surface(make_box({.size = {1, 1, 20}, .edge_length = 1}));
  const double quarter = std::numbers::pi / 2;
  struct Scene {
    Pose pose;
    Vec3d x_t0, x_t1;
  };
  const Scene moved{Pose({0, 0, 49}), {0, 0, 59.6}, {0, 0, 58.9}};
  const Scene turned{Pose({}, Quaternion::from_rotation({quarter, 0, 0})), {0, 10.6, 0.1}, {0, 9.9, 0.1}};
  for (const Scene& scene : {moved, turned}) {
    ContactDetector detector(surface, {.radius = ball});
    const std::vector<Vec3d> x_t0{scene.x_t0}, x_t1{scene.x_t1};
    for (int step = 0; step < 3; ++step) CHECK(detector.detect(fixtures::at_rest(), x_t0, x_t0).empty());
    CHECK(detector.swept().effort().points_tested <= 1);  // it is known to be far
    CHECK(detector.detect(fixtures::at_rest(scene.pose), x_t0, x_t1).size() == 1);
  }
}

TEST_CASE("plain call: a point that entered outside the contact bounds stays without contact when points are renumbered") {
  const Surface surface(make_box({.size = {1, 1, 1}, .edge_length = 0.25}));
  ContactDetector detector(surface, {.contact_bounds = BoxUnion({.size = {2, 2, 0.5}}, surface, Beyond::clip)});
  const Vec3d far{0, 0, 5}, above{0.4, 0, 0.26}, in{0.4, 0, 0.24}, deeper{0.4, 0, 0.23};
  CHECK(detector.detect(fixtures::at_rest(), std::vector<Vec3d>{far, above}, std::vector<Vec3d>{far, in}).empty());
  detector.points_changed();
  CHECK(detector.detect(fixtures::at_rest(), std::vector<Vec3d>{in, far}, std::vector<Vec3d>{deeper, far}).empty());
  CHECK(detector.swept().entered_inside() == 1);
}

TEST_CASE("plain call: points that start inside are reported, points in contact are not") {
  ContactDetector detector{Surface(make_box({.size = {1, 1, 1}, .edge_length = 1})), {.radius = ball}};
  const std::vector<Vec3d> x{{0, 0, 0}, {0, 0, 0.5 + ball}, {0, 0, 0.5 + 0.5 * ball}, {0, 0, 2}};
  CHECK(detector.points_inside(Pose(), x) == std::vector<std::size_t>{0, 2});
  CHECK(detector.points_inside(Pose({0, 0, 2}), x) == std::vector<std::size_t>{3});
}

TEST_CASE("plain call: without points there are no contacts") {
  ContactDetector detector{Surface(fixtures::tetrahedron())};
  CHECK(detector.detect(fixtures::at_rest(), {}, {}).empty());
}

TEST_CASE("plain call: invalid arguments are rejected with a message") {
  const Surface surface(fixtures::tetrahedron());
  CHECK_THROWS_WITH_AS(ContactDetector(surface, {.radius = -1}),
                       "contact: the contact radius is -1 m, but it must be a number of at least 0; 0 is for points without extent.", InputError);
  ContactDetector detector(surface, {});
  const std::vector<Vec3d> three(3), two(2);
  CHECK_THROWS_WITH_AS(detector.detect(fixtures::at_rest(), three, two),
                       "contact: there are 3 points at the beginning of the step and 2 at its end; give both positions of every point.", InputError);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    std::vector<Vec3d> astray(100, {2, 2, 2}), before = astray;
    astray[70].y = bad;
    CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), before, astray), RunError);
    CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), astray, before), RunError);
  }
  std::vector<Vec3d> astray(100, {2, 2, 2}), before = astray;
  astray[70].y = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(
      detector.detect(fixtures::at_rest(), before, astray),
      "contact: point 70 goes from (2, 2, 2) to (2, inf, 2) in one step, which is not finite; the solver has become unstable, use a shorter step.");
}

TEST_CASE("plain call: motions that are not finite and paths too long for detection are rejected, rather than without contact") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  ContactDetector detector{Surface(make_box({.size = {1, 1, 1}}))};
  const std::vector<Vec3d> above{{0, 0, 1}}, below{{0, 0, -1}};
  for (const double bad : {nan, infinity}) {
    for (const Motion& motion : {Motion{Pose({bad, 0, 0}), Pose(), 1}, Motion{Pose(), Pose({0, bad, 0}), 1}, Motion{Pose(), Pose({}, {1, bad, 0, 0}), 1},
                                 Motion{Pose(), Pose(), bad}, Motion{Pose(), Pose(), 1, {bad, 0, 0}}})
      CHECK_THROWS_AS(detector.detect(motion, above, below), InputError);
    CHECK_THROWS_AS(detector.points_inside(Pose({bad, 0, 0}), above), InputError);
    CHECK_THROWS_AS(detector.points_inside(Pose(), std::vector<Vec3d>{{bad, 0, 0}}), RunError);
    CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), std::vector<Vec3d>{{bad, 0, 0}}, std::vector<Vec3d>{{bad, 0, 0}}), RunError);
  }
  CHECK_THROWS_WITH_AS(detector.detect(Motion{Pose(), Pose({}, {2, 0, 0, 0}), 1}, above, below),
                       "motion at t1: the attitude of the pose is a quaternion of length 2, but it must be 1; normalise it.", InputError);
  for (const double far : {1e6, 1e150})
    CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), std::vector<Vec3d>{{0, 0, far}}, std::vector<Vec3d>{{0, 0, -far}}), RunError);
  CHECK_THROWS_WITH(
      detector.detect(fixtures::at_rest(), std::vector<Vec3d>{{0, 0, 1e150}}, below),
      "contact: point 0 goes from (0, 0, 1e+150) to (0, 0, -1) in one step, farther than 1e+06 m, beyond which rounding hides its contact; the solver has "
      "become unstable, use a shorter step.");
  CHECK(detector.detect(fixtures::at_rest(), above, below).size() == 1);  // rejected input has no effect
  CHECK(detector.detect(fixtures::at_rest(), std::vector<Vec3d>{{0, 0, 1e150}}, std::vector<Vec3d>{{0, 0, 1e150}}).empty());
}

TEST_CASE("plain call: on paths up to the longest allowed contact is found and relocated outside, accurate to the rounding of the path") {
  for (const double radius : {0.0, ball}) {
    for (const double far : {1e2, 1e4, 0.99e6}) {
      std::mt19937_64 random(11);
      for (int k = 0; k < 100; ++k) {
        ContactDetector detector{Surface(make_box({.size = {1, 1, 1}})), {.radius = radius}};
        const Vec3d direction = fixtures::random_direction(random), aim = 0.3 * fixtures::random_direction(random);
        const std::vector<Vec3d> x_t0{aim - 0.5 * far * direction}, x_t1{aim + 0.5 * far * direction};
        const std::vector<Contact> contacts = detector.detect(fixtures::at_rest(), x_t0, x_t1);
        REQUIRE(contacts.size() == 1);
        CHECK(detector.points_inside(Pose(), std::vector<Vec3d>{contacts[0].relocation}).empty());
        // the path's coordinates are rounded by half of 2.2e-16 of its length, and results computed from them somewhat more
        if (radius == 0) CHECK(largest_magnitude(contacts[0].hit) == fixtures::absolute(0.5, 4e-15 * far + 1e-12, "m"));
      }
    }
  }
}

namespace {

std::vector<double> radii_of(std::size_t points) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < points; ++i) radii.push_back(0.002 * double(1 + i % 10));
  return radii;
}

}  // namespace

TEST_CASE("plain call: points of different radii have the same contacts as the points of each radius alone, with a rotating hull, for any number of threads") {
  for (const int count : {1, 3}) {
    const fixtures::Threads with_several(count);
    Scene scene(1000);
    const SharedSurface surface = share(scene.surface);
    ContactDetector detector(surface);
    std::vector<ContactDetector> alone;
    for (const double radius : radii_of(10)) alone.emplace_back(surface, ContactDetector::Options{.radius = radius});
    const std::vector<double> radii = radii_of(1000);
    std::size_t found = 0;
    for (int step = 0; step < 100; ++step) {
      const Motion motion = scene.advance();
      const std::vector<Contact> contacts = detector.detect(motion, scene.x_t0, scene.x_t1, radii);
      std::vector<Contact> expected;
      for (std::size_t kind = 0; kind < 10; ++kind)
        for (const Contact& contact : alone[kind].detect(motion, scene.x_t0, scene.x_t1))
          if (contact.point % 10 == kind) expected.push_back(contact);
      std::ranges::sort(expected, {}, &Contact::point);
      REQUIRE(same(contacts, expected));
      found += contacts.size();
      respond(contacts, motion, scene.hull, {scene.x_t0, scene.x_t1, scene.velocity, scene.mass});
      for (ContactDetector& one : alone) one.points_changed();  // others were relocated with radii other than its own
    }
    CHECK(found > 100);
    CHECK(detector.swept().effort().points_tested < 1000 * 100 / 4);
    CHECK(detector.points_inside(scene.hull.pose(), scene.x_t1, radii).empty());
  }
}

TEST_CASE("plain call: a resting point of growing radius is relocated to its new radius, at the front of an open surface too") {
  Panels floor;
  floor.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  floor.add_quad(0, 1, 2, 3);
  for (const Surface& surface : {Surface(make_box({.size = {10, 10, 2}})), Surface(floor, {.orientation = Orientation::normals})}) {
    const double top = surface.is_closed() ? 1 : 0;
    ContactDetector detector(surface);
    const std::vector<Vec3d> x{{0, 0, top + 1}, {1, 0, top + 1}};
    for (int step = 0; step < 3; ++step) CHECK(detector.detect(fixtures::at_rest(), x, x, std::vector<double>{0.1, 0.1}).empty());
    const std::vector<Contact> contacts = detector.detect(fixtures::at_rest(), x, x, std::vector<double>{0.1, 1.5});
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].point == 1);
    CHECK(contacts[0].relocation.z == fixtures::absolute(top + 1.5, 1e-10, "m"));  // the offset, 1e-12 of 10 m, and roundings
  }
}

TEST_CASE("plain call: radii that are missing, negative or not a number are rejected") {
  ContactDetector detector{Surface(make_box({.size = {1, 1, 1}}))};
  const std::vector<Vec3d> x{{0, 0, 2}, {0, 0, 3}};
  CHECK_THROWS_WITH_AS(detector.detect(fixtures::at_rest(), x, x, std::vector<double>{0.1}),
                       "contact: the number of radii differs from the 2 points; give one for each, or one number for all.", InputError);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), x, x, std::vector<double>{0.1, bad}), InputError);
    CHECK_THROWS_AS(detector.points_inside(Pose(), x, std::vector<double>{0.1, bad}), InputError);
  }
  CHECK(detector.points_inside(Pose(), x, std::vector<double>{2, 2}) == std::vector<std::size_t>{0});
  CHECK(detector.points_inside(Pose(), x, 3.0) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("plain call: a point whose radius grew in a call that failed for another point is in contact in the next one") {
  ContactDetector detector{Surface(make_box({.size = {1, 1, 1}}))};
  const std::vector<Vec3d> x{{0, 0, 2}, {0, 0, 3}};
  CHECK(detector.detect(fixtures::at_rest(), x, x, std::vector<double>{0.1, 0.1}).empty());
  CHECK_THROWS_AS(detector.detect(fixtures::at_rest(), x, x, std::vector<double>{1.6, -1}), InputError);
  const std::vector<Contact> contacts = detector.detect(fixtures::at_rest(), x, x, std::vector<double>{1.6, 0.1});
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].point == 0);
}

TEST_CASE("plain call: detectors that share a surface find the same contacts as separate ones") {
  Scene scene(500);
  const SharedSurface shared = share(scene.surface);
  ContactDetector points(shared), balls(shared, {.radius = ball}), of_their_own(*scene.surface, {.radius = ball});
  CHECK(&points.swept().surface() == &balls.swept().surface());
  CHECK(shared.use_count() == 3);
  std::size_t found = 0;
  for (int step = 0; step < 100; ++step) {
    const Motion motion = scene.advance();
    const std::vector<Contact> contacts = balls.detect(motion, scene.x_t0, scene.x_t1);
    REQUIRE(same(contacts, of_their_own.detect(motion, scene.x_t0, scene.x_t1)));
    found += contacts.size();
    respond(contacts, motion, scene.hull, {scene.x_t0, scene.x_t1, scene.velocity, scene.mass});
  }
  CHECK(found > 50);
}

TEST_CASE("plain call: a ball that grows in front of an open surface is relocated, also from and to the radius of the detector, but not after a renumbering") {
  Panels square;
  square.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  square.add_quad(0, 1, 2, 3);
  const auto surface = share(Surface(square, {.orientation = Orientation::normals}));
  const Motion still = {Pose(), Pose(), 1e-3, {}};
  const std::vector<Vec3d> x{{0.3, 0.2, 0.15}, {0.3, 0.7, 9}};
  const std::vector<double> small{0.1, 0.1}, large{0.2, 0.2};
  const auto contacts = [&](double radius, const auto& before, const auto& then) {
    ContactDetector detector(surface, {.radius = radius});
    const auto soft = std::make_shared<DeformingSurface>(surface->surface());
    DeformingContactDetector deforming(soft, radius);
    before(detector), soft->move(square.vertices), before(deforming);
    const std::vector<Contact> found = then(detector);
    soft->move(square.vertices);
    const std::size_t of_deforming = then(deforming).size();
    CHECK(of_deforming == found.size());
    for (const Contact& contact : found) CHECK(contact.relocation.z == fixtures::absolute(0.2, 1e-10, "m"));  // and the offset of 1e-11
    return found.size();
  };
  const auto detect = [&](auto& detector, const auto&... radius) {
    if constexpr (std::is_same_v<std::decay_t<decltype(detector)>, ContactDetector>)
      return detector.detect(still, x, x, radius...);
    else
      return detector.detect(x, x, radius...);
  };
  CHECK(contacts(
            0, [&](auto& one) { detect(one, small); }, [&](auto& one) { return detect(one, large); }) == 1);
  CHECK(contacts(
            0.1, [&](auto& one) { detect(one); }, [&](auto& one) { return detect(one, large); }) == 1);
  CHECK(contacts(
            0.2, [&](auto& one) { detect(one, small); }, [&](auto& one) { return detect(one); }) == 1);
  // Another point may have this number: it starts inside, and is regarded as one that came round the boundary.
  CHECK(contacts(
            0,
            [&](auto& one) {
              detect(one, small);
              one.points_changed();
            },
            [&](auto& one) { return detect(one, large); }) == 0);
}

TEST_CASE("plain call: points stored as floats never end inside, nor behind an open surface, with radius or without") {
  Panels valley;  // a floor and a wall
  valley.vertices = {{-9, -9, 0}, {1, -9, 0}, {1, 9, 0}, {-9, 9, 0}, {2, -9, 9}, {2, 9, 9}};
  valley.add_quad(0, 1, 2, 3);
  valley.add_quad(1, 4, 5, 2);
  for (const double radius : {0.0, ball}) {
    ContactDetector detector(Surface(valley, {.orientation = Orientation::normals}), {.radius = radius});
    RigidBody body({.mass = 1}, Pose({100.1, 0, 0}), {}, {}, {});  // coordinates of 100 m are rounded by 4e-6 m
    std::mt19937_64 random(3);
    std::vector<float> x_t1, velocity(3 * 200);
    for (int i = 0; i < 200; ++i) {
      const Vec3d place = Vec3d{97, 0, 3} + 2.0 * fixtures::random_direction(random);
      for (const double c : {place.x, place.y, place.z}) x_t1.push_back(float(c));
    }
    const double dt = 0.02;
    std::size_t found = 0;
    for (int step = 0; step < 300; ++step) {
      const std::vector<float> x_t0 = x_t1;
      for (std::size_t i = 0; i < 200; ++i) {
        velocity[3 * i] += float(3 * dt), velocity[3 * i + 2] -= float(9.81 * dt);
        for (std::size_t c = 0; c < 3; ++c) x_t1[3 * i + c] += float(dt) * velocity[3 * i + c];
      }
      const Motion motion = body.advance(dt);
      const std::vector<Contact> contacts = detector.detect(motion, x_t0, x_t1);
      found += contacts.size();
      respond(contacts, motion, body, {x_t0, x_t1, velocity, 1.0});
    }
    CHECK(found > 10000);
    std::size_t behind = 0;
    for (std::size_t i = 0; i < 200; ++i) {
      const double x = double(x_t1[3 * i]) - 100.1, z = x_t1[3 * i + 2];
      behind += z < 0 || 9 * (x - 1) - z > 0;  // the wall's plane goes through (1, 0) and (2, 9)
    }
    CHECK(behind == 0);
  }
}
