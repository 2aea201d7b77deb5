#include "fccda/deforming/respond.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>

#include "fccda/deforming/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

namespace {

/// A body that bends, and balls that it meets.
struct Impact {
  Panels panels = fixtures::hull();
  std::shared_ptr<DeformingSurface> surface = std::make_shared<DeformingSurface>(Surface(panels));
  TestPoints points;
  std::vector<DeformingContact> contacts;
  std::vector<double> vertex_mass;
  double dt = 1e-3;

  explicit Impact(double radius) {
    surface->move(displaced(panels, deformations()[1], 0.01));
    surface->move(displaced(panels, deformations()[1], 0.03));
    std::mt19937_64 random(31);
    std::uniform_real_distribution<double> unit(0, 1);
    const Soup at_t0(surface->at_t0());
    while (points.size() < 300) {
      const Path path = path_near(*surface, radius + 0.05, 0.1, random);
      if (at_t0.distance(path.start) < radius + 1e-6 || at_t0.inside(path.start)) continue;
      points.x0.push_back(path.start), points.x1.push_back(path.end);
      points.v.push_back((path.end - path.start) / dt);
      points.m.push_back(1 + unit(random));
    }
    for (std::size_t v = 0; v < panels.vertices.size(); ++v) vertex_mass.push_back(5 + unit(random));
    Deforming detector(surface, radius);
    contacts = deforming::detect(detector, points);
    for (DeformingContact& contact : contacts) contact.contact.sliding = nullptr;
  }

  /// Where a vertex is at t1.
  std::vector<Vec3d> vertices() const { return displaced(panels, deformations()[1], 0.03); }
};

}  // namespace

TEST_CASE("deforming response: linear and angular momentum of points and vertices are conserved, with friction and without") {
  for (const double radius : {0.0, 0.03})
    for (const double friction : {0.0, 0.4})
      for (const bool yields : {false, true}) {
        Impact impact(radius);
        REQUIRE(impact.contacts.size() > 30);
        const TestPoints before = impact.points;
        std::vector<Vec3d> impulses(impact.panels.vertices.size());
        const ContactSum sum = respond(
            impact.points, impact.contacts, impact.dt, friction, [&](std::size_t v) { return yields ? 1 / impact.vertex_mass[v] : 0.0; }, impulses);
        Vec3d linear{}, angular{};
        double largest = 0, moment = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
          const Vec3d change = before.m[i] * (impact.points.v[i] - before.v[i]);
          linear += change, angular += cross(impact.points.x1[i], change);
          largest += norm(change), moment += norm(cross(impact.points.x1[i], change));
        }
        const std::vector<Vec3d> place = impact.vertices();
        Vec3d on_surface{}, moment_on_surface{};
        for (std::size_t v = 0; v < place.size(); ++v) on_surface += impulses[v], moment_on_surface += cross(place[v], impulses[v]);
        CHECK(norm(linear + on_surface) == fixtures::absolute(0, 1e-12 * largest, "N s"));
        CHECK(norm(angular + moment_on_surface) == fixtures::absolute(0, 1e-12 * moment, "N m s"));
        CHECK(norm(sum.impulse - on_surface) == fixtures::absolute(0, 1e-12 * largest, "N s"));
        CHECK(norm(sum.angular_impulse - moment_on_surface) == fixtures::absolute(0, 1e-12 * moment, "N m s"));
        CHECK(sum.contacts == impact.contacts.size());
      }
}

TEST_CASE("deforming response: an impulse is distributed with its moment, wherever it acts and however thin the triangle is") {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  for (int k = 0; k < 1000; ++k) {
    Corners t{place(), place(), place()};
    const double thin = k % 2 == 0 ? 1 : 1e-3;
    t.c = t.b + thin * (t.c - t.b);
    const Vec3d impulse = place(), at = t.a + 0.3 * place();
    const std::array<double, 3> weights = barycentric(t, at);
    const std::array<Vec3d, 3> j = vertex_impulses(impulse, at, t, weights);
    // The couple is carried by opposite forces a height apart.
    const double scale = 1 + norm(j[0]) + norm(j[1]) + norm(j[2]);
    CHECK(norm(j[0] + j[1] + j[2] - impulse) == fixtures::absolute(0, 1e-12 * scale, "N s"));
    CHECK(norm(cross(t.a, j[0]) + cross(t.b, j[1]) + cross(t.c, j[2]) - cross(at, impulse)) == fixtures::absolute(0, 1e-12 * scale, "N m s"));
  }
}

TEST_CASE("deforming response: without friction the vertices share the impulse by their weights") {
  const Corners t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::array<double, 3> weights{0.5, 0.3, 0.2};
  const std::array<Vec3d, 3> j = vertex_impulses({0, 0, -2}, {0.3, 0.2, 0.1}, t, weights);
  for (std::size_t k = 0; k < 3; ++k) CHECK(norm(j[k] - Vec3d{0, 0, -2 * weights[k]}) == fixtures::absolute(0, 1e-15, "N s"));
}

TEST_CASE("deforming response: a ball and a vertex of one mass, head on, go on together") {
  // A cap whose tip, of mass 1, is at rest; a point of mass 1 falls on it.
  Panels cap;
  cap.vertices = {{0, 0, 0}, {1, 0, -0.1}, {0, 1, -0.1}, {-1, 0, -0.1}, {0, -1, -0.1}};
  for (int k = 0; k < 4; ++k) cap.add_triangle(0, 1 + k, 1 + (k + 1) % 4);
  const auto surface = std::make_shared<DeformingSurface>(Surface(cap, {.orientation = Orientation::normals}));
  surface->move(cap.vertices);
  TestPoints points;
  points.x0 = {{0, 0, 0.2}}, points.x1 = {{0, 0, 0.0}}, points.v = {{0, 0, -2}}, points.m = {1};
  Deforming detector(surface, 0.1);
  const std::vector<DeformingContact> contacts = deforming::detect(detector, points);
  REQUIRE(contacts.size() == 1);
  std::vector<Vec3d> impulses(5);
  respond(
      points, contacts, 0.1, 0, [](std::size_t) { return 1.0; }, impulses);
  // At an unyielding tip the point would be left with 1 m/s down, the way from 0.2 to 0.1 m: it loses 1 m/s, of which the tip takes half.
  CHECK(points.v[0].z == fixtures::relative(-1.5, 1e-9));
  CHECK(impulses[0].z == fixtures::relative(-0.5, 1e-9));
  CHECK(points.x1[0].z == fixtures::relative(0.1, 1e-9));
}

namespace {

/// Points that fall on a loose sheet in one step: their velocities and those of its vertices before and after.
struct Fall {
  Panels panels = sheet(4);
  std::vector<Vec3d> vertex_velocity = std::vector<Vec3d>(panels.vertices.size(), Vec3d{0, 0, 0.5});
  TestPoints points;
  double vertex_mass = 0.2, dt = 1e-3;
  std::vector<DeformingContact> contacts;

  void add(const Vec3d& place, const Vec3d& velocity, double mass) {
    points.x0.push_back(place), points.x1.push_back(place + dt * velocity), points.v.push_back(velocity), points.m.push_back(mass);
  }
  void respond_to_contacts(double friction) {
    const auto surface = open_surface(panels);
    surface->move(panels.vertices);
    std::vector<Vec3d> vertices = panels.vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] += dt * vertex_velocity[v];
    surface->move(vertices);
    Deforming detector(surface, 0.001);
    contacts = deforming::detect(detector, points);
    for (DeformingContact& contact : contacts) contact.contact.sliding = nullptr;
    std::vector<Vec3d> impulses(vertices.size());
    respond(
        points, contacts, dt, friction, [&](std::size_t) { return 1 / vertex_mass; }, impulses);
    for (std::size_t v = 0; v < vertices.size(); ++v) vertex_velocity[v] += impulses[v] / vertex_mass;
  }
  Vec3d momentum() const {
    Vec3d sum{};
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * points.v[i];
    for (const Vec3d& v : vertex_velocity) sum += vertex_mass * v;
    return sum;
  }
  double energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += 0.5 * points.m[i] * squared_norm(points.v[i]);
    for (const Vec3d& v : vertex_velocity) sum += 0.5 * vertex_mass * squared_norm(v);
    return sum;
  }
  /// [m/s] of a point along the normal, relative to the panel that it meets.
  double parting(const DeformingContact& contact) const {
    Vec3d panel{};
    for (std::size_t k = 0; k < 3; ++k) panel += contact.place.weights[k] * vertex_velocity[static_cast<std::size_t>(contact.place.vertices[k])];
    return dot(points.v[contact.contact.point] - panel, contact.contact.normal);
  }
};

}  // namespace

TEST_CASE("deforming response: many heavy points that meet light vertices in one step leave with them, and neither momentum nor energy is added") {
  for (const double friction : {0.0, 0.3})
    for (const double ratio : {0.1, 1.0, 30.0}) {  // mass of a point over that of a vertex; some 20 points meet the panels of each vertex
      Fall fall;
      std::mt19937_64 random(43);
      std::uniform_real_distribution<double> unit(-1, 1);
      for (int i = 0; i < 100; ++i) fall.add({0.4 * unit(random), 0.4 * unit(random), 0.001 + 1e-9}, {0.2, 0, -2}, 0.2 * ratio);
      const Vec3d before = fall.momentum();
      const double energy = fall.energy();
      fall.respond_to_contacts(friction);
      REQUIRE(fall.contacts.size() == 100);
      CHECK(norm(fall.momentum() - before) == fixtures::absolute(0, 1e-12 * norm(before), "N s"));
      CHECK(fall.energy() < energy);
      CHECK(fall.energy() > 0.5 * squared_norm(before) / (0.2 * (25 + 100 * ratio)));  // of all moving as one
      // A panel that retreats from a point leaves it behind; none is left that approaches. 1e-3: of the closing speed, after the last sweep.
      for (const DeformingContact& contact : fall.contacts) CHECK(fall.parting(contact) >= -2.5e-3);
    }
}

TEST_CASE("deforming response: a point is not pulled along by a panel that a heavier point drives away") {
  Fall fall;
  fall.vertex_velocity.assign(fall.panels.vertices.size(), Vec3d{});
  fall.add({0.02, 0.02, 0.001 + 1e-9}, {0, 0, -0.01}, 0.1);
  fall.add({0.03, 0.03, 0.001 + 1e-9}, {0, 0, -3}, 50);
  fall.respond_to_contacts(0);
  REQUIRE(fall.contacts.size() == 2);
  CHECK(fall.points.v[0] == Vec3d{0, 0, -0.01});
  CHECK(fall.points.v[1].z < -2.9);
  CHECK(fall.points.v[1].z > -3);
}

TEST_CASE("deforming response: a surface that moves rigidly acts as a rigid body with prescribed motion does") {
  const Panels panels = fixtures::hull();
  const auto rigid = fixtures::surface_of(panels);
  const auto surface = std::make_shared<DeformingSurface>(*rigid);
  const Vec3d way{0.03, -0.02, 0.04};
  std::vector<Vec3d> vertices = panels.vertices;
  surface->move(vertices);
  for (Vec3d& x : vertices) x += way;
  surface->move(vertices);
  const Motion motion{Pose(), Pose(way), 1e-3};
  const Impact other(0.03);
  TestPoints a = other.points;
  const Soup at_rest(*rigid);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (at_rest.inside(a.x0[i]) || at_rest.distance(a.x0[i]) < 0.031) a.x0[i] = a.x1[i] = {5, 5, 5 + double(i)};
  for (std::size_t i = 0; i < a.size(); ++i) a.v[i] = (a.x1[i] - a.x0[i]) / motion.dt;
  TestPoints b = a;
  Swept swept(rigid, Unbounded(), 0.03);
  Deforming deforming(surface, 0.03);
  const std::vector<Contact> expected = fixtures::detect(swept, a, motion, norm(way));
  const std::vector<DeformingContact> found = deforming::detect(deforming, b);
  REQUIRE(found.size() == expected.size());
  REQUIRE(found.size() > 10);
  const ContactSum of_rigid = resolve_points(a, expected, motion, {}, 0.3, [](const Contact&, const Vec3d&) {});
  std::vector<Vec3d> impulses(vertices.size());
  const ContactSum of_deforming = respond(
      b, found, motion.dt, 0.3, [](std::size_t) { return 0.0; }, impulses);
  CHECK(norm(of_rigid.impulse - of_deforming.impulse) == fixtures::absolute(0, 1e-7 * norm(of_rigid.impulse), "N s"));
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(norm(a.v[i] - b.v[i]) == fixtures::absolute(0, 1e-6, "m/s"));
}

TEST_CASE("deforming response: friction adds no energy where points that press on two sides of a fold drag it along") {
  // A fold along y, of light vertices between prescribed borders. The two sides hold each other along their normals, not along the fold.
  Panels fold;
  for (const double y : {-1.0, 0.0, 1.0})
    for (const Vec3d& corner : {Vec3d{-0.02, y, 0}, Vec3d{0, y, 1}, Vec3d{0.02, y, 0}}) fold.vertices.push_back(corner);
  for (int a : {0, 3}) {
    fold.add_triangle(a + 3, a, a + 1), fold.add_triangle(a + 4, a + 3, a + 1);
    fold.add_triangle(a + 5, a + 4, a + 1), fold.add_triangle(a + 2, a + 5, a + 1);
  }
  const double dt = 0.02;
  for (const double friction : {0.0, 0.3, 2.0})
    for (const double mass : {1e-4, 1e-2, 1.0}) {
      const auto surface = open_surface(fold);
      surface->move(fold.vertices);
      TestPoints points;
      for (const double y : {-0.1, 0.3})
        for (const double side : {-1.0, 1.0}) {
          points.x0.push_back({0.02 * side, y, 0.5}), points.v.push_back({-side, 3, 0}), points.m.push_back(1);
          points.x1.push_back(points.x0.back() + dt * points.v.back());
        }
      const double energy = 0.5 * 4 * 10;
      Deforming detector(surface, 0);
      const std::vector<DeformingContact> contacts = deforming::detect(detector, points);
      REQUIRE(contacts.size() == 4);
      std::vector<Vec3d> impulses(9);
      respond(
          points, contacts, dt, friction, [&](std::size_t v) { return v % 3 == 1 ? 1 / mass : 0.0; }, impulses);
      double after = 0;
      for (const Vec3d& v : points.v) after += 0.5 * squared_norm(v);
      for (const std::size_t v : {1, 4, 7}) after += 0.5 * squared_norm(impulses[v]) / mass;
      CHECK(after < energy);
    }
}
