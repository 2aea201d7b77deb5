#include "fccda/respond/resolve_together.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/parallel.hpp"
#include "fccda/detect/all_detectors.hpp"
#include "fccda/detect/scene.hpp"
#include "fccda/respond/respond.hpp"
#include "fixtures/threads.hpp"

using namespace fccda;

namespace {

constexpr FreeDegrees all_free{{true, true, true, true, true, true}};

/// A body in contact, as a user of the library implements it.
struct Striking {
  RigidBody body;
  Swept detector;
  double radius;
  double friction = 0;
  Motion motion{};
  std::vector<Contact> contacts{};

  Striking(const Panels& panels, double contact_radius, const Vec3d& velocity, const Vec3d& spin = {}, const FreeDegrees& degrees = {})
      : Striking(fixtures::surface_of(panels), contact_radius, velocity, spin, degrees) {}
  Striking(std::shared_ptr<const Surface> surface, double contact_radius, const Vec3d& velocity, const Vec3d& spin = {}, const FreeDegrees& degrees = {})
      : body({.mass = 20, .centre_of_mass = {}, .inertia = Mat3::diagonal({2, 3, 4})}, Pose(), velocity, spin, degrees),
        detector(std::move(surface), Unbounded{}, contact_radius),
        radius(detector.surface().radius_about({})) {}

  void advance(double dt) { motion = body.advance(dt); }
  template <class P>
  std::span<const Contact> resolve_contact(P& points) {
    contacts.clear();
    detector.detect(points, motion, body.travel_bound(motion, radius), contacts);
    respond(points, contacts, motion, body, friction);
    return contacts;
  }
  template <class P>
  std::span<const Contact> resolve_contact_again(P& points, std::span<const std::size_t> which) {
    contacts.clear();
    detector.detect_again(points, motion, body.travel_bound(motion, radius), which, contacts);
    respond(points, contacts, motion, body, friction);
    return contacts;
  }
  std::vector<std::size_t> still_inside(const fixtures::TestPoints& points, std::span<const std::size_t> which) {
    return detector.still_inside(points, motion, which);
  }
  void moved(std::size_t i) { detector.moved(i); }
};

using UnresolvedPenetration = std::vector<std::vector<std::size_t>>;

UnresolvedPenetration step(std::vector<Striking>& resolvers, fixtures::TestPoints& points, double dt) {
  points.x0 = points.x1;
  for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += dt * points.v[i];
  for (Striking& resolver : resolvers) resolver.advance(dt);
  return resolve_together(std::span(resolvers), points);
}

std::size_t count(const UnresolvedPenetration& unresolved) {
  std::size_t sum = 0;
  for (const auto& list : unresolved) sum += list.size();
  return sum;
}

fixtures::TestPoints points_at(const std::vector<Vec3d>& places) {
  return {places, places, std::vector<Vec3d>(places.size()), std::vector<double>(places.size(), 0.5)};
}

Vec3d momentum(const std::vector<Striking>& resolvers, const fixtures::TestPoints& points) {
  Vec3d sum;
  for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * points.v[i];
  for (const Striking& resolver : resolvers) sum += resolver.body.momentum();
  return sum;
}

/// A wall with the outward normal `normal`, at the distance `where` from the origin.
Panels wall(const Vec3d& normal, double where) {
  const Quaternion turn = Quaternion::from_rotation(std::atan2(normal.y, normal.x) * Vec3d{0, 0, 1});
  const Mat3 matrix = turn.matrix();
  return fixtures::moved(make_box({.size = {0.4, 4, 2}, .edge_length = 0.4}), [&](const Vec3d& p) { return matrix * (p + Vec3d{where - 0.2, 0, 0}); });
}

}  // namespace

TEST_CASE("together: points that two walls push into their corner end outside both, without unresolved penetration") {
  for (const double r : {0.0, 0.03}) {
    CAPTURE(r);
    // the walls x = 0 and y = 0 advance by 0.05
    std::vector<Striking> walls;
    walls.emplace_back(wall({1, 0, 0}, 0), r, Vec3d{0.05, 0, 0});
    walls.emplace_back(wall({0, 1, 0}, 0), r, Vec3d{0, 0.05, 0});
    std::mt19937_64 random(61);
    std::vector<Vec3d> places;
    for (int i = 0; i < 300; ++i) places.push_back(Vec3d{r, r, 0} + fixtures::random_in_box(random, {1e-6, 1e-6, -0.5}, {0.1, 0.1, 0.5}));
    fixtures::TestPoints points = points_at(places);
    CHECK(count(step(walls, points, 1)) == 0);
    std::size_t in_corner = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec3d expected{std::max(places[i].x, 0.05 + r), std::max(places[i].y, 0.05 + r), places[i].z};
      CHECK(norm(points.x1[i] - expected) < 1e-11);  // the offset is 4e-12
      in_corner += expected.x != places[i].x && expected.y != places[i].y;
    }
    CHECK(in_corner > 50);
  }
}

namespace {

/// Points with the distance travelled of their own motion, as a solver knows it at the start of the step.
struct SolverPoints : fixtures::TestPoints {
  double travel = 0;
  double block_travel(std::size_t) const { return travel; }
};

}  // namespace

TEST_CASE("together: a point that one impactor moves into another is detected there, however far away it was") {
  // the first wall sweeps 0.5 along x and carries a point at rest to the other wall, initially 0.45 away
  for (const bool sweeper_first : {true, false}) {
    CAPTURE(sweeper_first);
    std::vector<Striking> walls;
    walls.emplace_back(wall({-1, 0, 0}, -0.5), 0.0, Vec3d{});
    walls.emplace_back(wall({1, 0, 0}, 0), 0.0, Vec3d{0.5, 0, 0});
    if (sweeper_first) std::swap(walls[0], walls[1]);
    SolverPoints points;
    static_cast<fixtures::TestPoints&>(points) = points_at({{0.05, 0.1, 0.1}});
    for (Striking& resolver : walls) resolver.motion = {Pose(), Pose(), 1};
    for (Striking& resolver : walls) CHECK(resolver.resolve_contact(points).empty());  // all know how far it is
    for (Striking& resolver : walls) resolver.advance(1);
    points.v = {{}};
    const UnresolvedPenetration unresolved = resolve_together(std::span(walls), points);
    CHECK(std::fabs(points.x1[0].x - 0.5) < 1e-10);  // between the two, which are now in contact
    CHECK(count(unresolved) == 0);
    points.x0 = points.x1;
    for (Striking& resolver : walls) resolver.motion = {resolver.motion.t1, resolver.motion.t1, 1};
    points.x1[0].x += 0.1;  // further into the wall at rest
    points.travel = 0.1;
    resolve_together(std::span(walls), points);
    CHECK(std::fabs(points.x1[0].x - 0.5) < 1e-10);
  }
}

TEST_CASE("together: a wedge of two closing walls expels points along its bisector") {
  // Between its faces are 60°, 75°, 90°, 120°; each advances by 0.01.
  for (const double opening : {60.0, 75.0, 90.0, 120.0}) {
    CAPTURE(opening);
    const double half = 0.5 * opening * std::numbers::pi / 180;
    const Vec3d n{std::sin(half), std::cos(half), 0}, m{std::sin(half), -std::cos(half), 0};  // both face +x
    std::vector<Striking> walls;
    for (const Vec3d& normal : {n, m}) walls.emplace_back(wall(normal, 0), 0.0, 0.01 * normal);
    fixtures::TestPoints points = points_at({{0.001, 0, 0}, {0.004, 0.0002, 0.1}, {0.02, 0, 0.2}});
    const UnresolvedPenetration unresolved = step(walls, points, 1);
    if (opening >= 90) CHECK(count(unresolved) == 0);
    for (std::size_t i = 0; i < 3; ++i) {
      // Each pass reduces the depth, 0.02 at most, by a fraction 1 - cos(opening); seven passes follow the first.
      const double left = opening >= 90 ? 1e-10 : 0.02 * std::pow(std::cos(2 * half), 7);
      const double depth = 0.01 - std::min(dot(points.x1[i], n), dot(points.x1[i], m));
      CHECK(depth < left);
      CHECK(points.x1[i].x >= 0.01 / std::sin(half) - 2 * left / std::sin(half));  // the edge of the wedge has come so far
      const bool is_unresolved =
          std::any_of(unresolved.begin(), unresolved.end(), [&](const auto& list) { return std::count(list.begin(), list.end(), i) > 0; });
      CHECK(is_unresolved == (depth > 4e-9));  // 1e-9 of the walls' size counts as contact
    }
  }
}

TEST_CASE("together: a point in a closing vice is an unresolved penetration, is counted, and is free when the vice opens") {
  const double r = 0.03;
  std::vector<Striking> jaws;
  jaws.emplace_back(wall({1, 0, 0}, -0.05), r, Vec3d{0.01, 0, 0});
  jaws.emplace_back(wall({-1, 0, 0}, -0.05), r, Vec3d{-0.01, 0, 0});
  std::mt19937_64 random(62);
  std::vector<Vec3d> places;
  for (int i = 0; i < 200; ++i) places.push_back(fixtures::random_in_box(random, {-0.019, -0.5, -0.5}, {0.019, 0.5, 0.5}));
  fixtures::TestPoints points = points_at(places);
  for (int k = 0; k < 2; ++k) {  // to a gap of 0.06, which is 2 r to rounding: no unresolved penetration
    for (Vec3d& v : points.v) v = {};
    CHECK(count(step(jaws, points, 0.999)) == 0);
  }
  for (Vec3d& v : points.v) v = {};
  const UnresolvedPenetration unresolved = step(jaws, points, 1);  // 0.04 between the jaws
  CHECK(count(unresolved) == places.size());
  for (const Vec3d& x : points.x1) CHECK(std::fabs(x.x) < 0.02 + 1e-9);  // not relocated to the far side of a jaw
  for (Vec3d& v : points.v) v = {};
  for (Striking& jaw : jaws) jaw.body = RigidBody(jaw.body.properties(), jaw.body.pose(), -1.0 * jaw.body.velocity(), {}, {});
  CHECK(count(step(jaws, points, 3)) == 0);  // apart again: 0.1
  for (const Vec3d& x : points.x1) CHECK(std::fabs(x.x) < 0.05 - r + 1e-9);
}

namespace {

/// An open plate of 2 × 2 in the plane x = `where`, its front towards +x.
std::shared_ptr<const Surface> open_plate(double where) {
  Panels plate;
  plate.vertices = {{where, -1, -1}, {where, 1, -1}, {where, 1, 1}, {where, -1, 1}};
  plate.add_quad(0, 1, 2, 3);
  return std::make_shared<const Surface>(plate, Surface::Options{.orientation = Orientation::normals});
}

}  // namespace

TEST_CASE("together: an open plate keeps contact with points against a jaw that closes on it over many steps, whichever acts first") {
  // Gap and radius are 0.07 and 0.03; the jaw closes by 0.002 per step, so that points penetrate deeper than the travel of a step from
  // the seventh step on.
  const double r = 0.03;
  for (const bool plate_first : {true, false}) {
    CAPTURE(plate_first);
    std::vector<Striking> jaws;
    jaws.emplace_back(open_plate(-0.035), r, Vec3d{});
    jaws.emplace_back(wall({-1, 0, 0}, -0.035), r, Vec3d{-0.002, 0, 0});
    if (!plate_first) std::swap(jaws[0], jaws[1]);
    const Striking& plate = jaws[plate_first ? 0 : 1];
    std::mt19937_64 random(64);
    std::vector<Vec3d> places;
    for (int i = 0; i < 50; ++i) places.push_back(fixtures::random_in_box(random, {-0.004, -0.5, -0.5}, {0.004, 0.5, 0.5}));
    fixtures::TestPoints points = points_at(places);
    for (int k = 1; k <= 16; ++k) {
      CAPTURE(k);
      for (Vec3d& v : points.v) v = {};
      const UnresolvedPenetration unresolved = step(jaws, points, 1);
      CHECK(count(unresolved) == (k > 5 ? places.size() : 0));  // the gap of 0.06 after five steps is 2 r; penetration by the offset counts as contact
      if (k > 5) CHECK(plate.contacts.size() == places.size());
    }
    CHECK(plate.detector.entered_inside() == 0);
    jaws[plate_first ? 1 : 0].body = RigidBody(jaws[0].body.properties(), jaws[plate_first ? 1 : 0].body.pose(), {0.05, 0, 0}, {}, {});
    for (Vec3d& v : points.v) v = {};
    CHECK(count(step(jaws, points, 1)) == 0);  // apart again: the plate relocates all points to its front
    for (const Vec3d& x : points.x1) CHECK(x.x > -0.035 + r - 1e-9);
  }
}

namespace {

struct Closing {
  std::vector<Vec3d> places;
  std::size_t unresolved = 0, contacts = 0;
  double momentum_error = 0;  // over all that was exchanged
  bool all_outside = true, unresolved_are_inside = true;
};

/// Three free, rotating spheres that move into a point cloud from three sides.
Closing closing_spheres(bool forget) {
  const double r = 0.02, dt = 0.02;
  std::vector<Striking> spheres;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3;
    const Vec3d direction{std::cos(angle), std::sin(angle), 0};
    const Panels sphere = fixtures::moved(make_sphere({.diameter = 1, .edge_length = 0.3}), [&](const Vec3d& p) { return p + 0.75 * direction; });
    spheres.emplace_back(sphere, r, -1.0 * direction, Vec3d{0.2, -0.1, 0.3 * k}, all_free);
  }
  std::mt19937_64 random(63);
  std::vector<Vec3d> places;
  while (places.size() < 400) {
    const Vec3d place = fixtures::random_in_box(random, {-0.5, -0.5, -0.3}, {0.5, 0.5, 0.3});
    const bool outside = std::all_of(spheres.begin(), spheres.end(),
                                     [&](const Striking& sphere) { return norm(place - sphere.detector.surface().report().centroid) > 0.5 + r; });
    if (outside) places.push_back(place);
  }
  fixtures::TestPoints points = points_at(places);
  const Vec3d before = momentum(spheres, points);
  double exchanged = 0;
  std::vector<fixtures::Soup> soups;
  for (const Striking& sphere : spheres) soups.emplace_back(sphere.detector.surface());
  Closing result;
  for (int k = 0; k < 12; ++k) {
    if (forget)
      for (Striking& sphere : spheres) sphere.detector.forget();
    const std::vector<Vec3d> v = points.v;
    const UnresolvedPenetration unresolved = step(spheres, points, dt);
    for (std::size_t i = 0; i < points.size(); ++i) exchanged += points.m[i] * norm(points.v[i] - v[i]);
    for (const Striking& sphere : spheres) result.contacts += sphere.contacts.size();
    result.unresolved += count(unresolved);
    if (k % 4 != 3) continue;  // for the sake of the oracle
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::size_t inside_of = 0, named = 0;
      for (std::size_t s = 0; s < spheres.size(); ++s) {
        const Vec3d place = spheres[s].body.pose().to_body(points.x1[i]);
        const bool inside = soups[s].distance(place) < r - 1e-8 || soups[s].inside(place);
        const bool is_named = std::count(unresolved[s].begin(), unresolved[s].end(), i) > 0;
        inside_of += inside, named += is_named;
        if (is_named && !inside && soups[s].distance(place) > r) result.unresolved_are_inside = false;
      }
      if (inside_of > named) result.all_outside = false;
    }
  }
  result.momentum_error = norm(momentum(spheres, points) - before) / exchanged;
  result.places = points.x1;
  return result;
}

}  // namespace

TEST_CASE("together: after three spheres close in on a cloud each point is outside all of them or reported as unresolved, and momentum is conserved") {
  const Closing closing = closing_spheres(false);
  CHECK(closing.contacts > 100);
  CHECK(closing.all_outside);
  CHECK(closing.unresolved_are_inside);
  CHECK(closing.momentum_error < 1e-13);  // rounding of some thousand impulses
}

TEST_CASE("together: results are bitwise identical without the distance cache and for any number of threads") {
  const fixtures::Threads with_one(1);
  const std::vector<Vec3d> places = closing_spheres(false).places;
  CHECK(closing_spheres(true).places == places);
  for (const int count : {2, 4}) {
    const fixtures::Threads with_several(count);
    CHECK(closing_spheres(false).places == places);
  }
}

TEST_CASE("together: the published and the analytic detector support repeated passes too") {
  const auto ball = fixtures::surface_of(make_sphere({.diameter = 1, .edge_length = 0.05}));
  fixtures::TestPoints points = points_at({{0.6, 0, 0}, {0.4, 0.01, 0.02}, {0, 0.01, 0.7}, {0.02, 0.01, 0.45}});
  points.x0[1] = {0.6, 0.01, 0.02}, points.x0[3] = {0.02, 0.01, 0.6};
  const std::vector<std::size_t> which{1, 2};
  const Motion motion = fixtures::at_rest();
  Published published(ball, Unbounded{}, Published::Variant::corrected);
  Analytic analytic(Sphere{.radius = 0.5}, Unbounded{}, 0);
  Swept swept(ball, Unbounded{}, 0);
  const auto again = [&](auto& detector) {
    fixtures::TestPoints before = points;
    before.x1 = before.x0;
    CHECK(fixtures::detect(detector, before, motion).empty());
    CHECK(detector.still_inside(points, motion, which) == std::vector<std::size_t>{1});
    std::vector<Contact> contacts;
    detector.detect_again(points, motion, 0, which, contacts);
    REQUIRE(contacts.size() == 1);  // the fourth is not requested
    CHECK(contacts[0].point == 1);
    CHECK(std::fabs(norm(contacts[0].relocation) - 0.5) < 2e-3);  // the panels are 0.05²/8/0.5 inside the sphere
  };
  again(published);
  again(analytic);
  again(swept);
}
