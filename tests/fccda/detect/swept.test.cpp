#include "fccda/detect/swept.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "fccda/deforming/deforming.hpp"
#include "fccda/detect/scene.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

std::vector<bool> resolved(const std::vector<Contact>& contacts, std::size_t points) {
  std::vector<bool> is(points, false);
  for (const Contact& contact : contacts) is[contact.point] = true;
  return is;
}

}  // namespace

TEST_CASE("swept: every true crossing is found and no false one, on every body, in 24 orientations, for points and for balls") {
  std::size_t true_contacts = 0;
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const fixtures::Shots shots(soup, r, 0.05, 150, 1);
      for (const Pose& pose : fixtures::orientations()) {
        Swept detector(surface, Unbounded{}, r);
        const std::vector<Contact> contacts = detect(detector, fixtures::points_on(shots.paths, {pose, pose, 1}), {pose, pose, 1});
        const std::vector<bool> found = resolved(contacts, shots.paths.size());
        CHECK(found == shots.touches);  // exact: no tolerance
        true_contacts += contacts.size();
      }
    }
  }
  CHECK(true_contacts > 24 * 6 * 2 * 40);  // the scenes are not empty
}

TEST_CASE("swept: relocated points are outside, at the contact radius from the surface, and reached without crossing it") {
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const fixtures::Shots shots(soup, r, 0.05, 150, 2);
      Swept detector(surface, Unbounded{}, r);
      for (const Contact& contact : detect(detector, fixtures::points_on(shots.paths))) {
        const double distance = soup.distance(contact.relocation);
        CHECK(distance > r - 2e-12);  // the offset of 1e-12 of the size
        CHECK_FALSE(soup.inside(contact.relocation + 1e-6 * contact.normal));
        CHECK(std::fabs(norm(contact.normal) - 1) < 1e-12);
        const Path way{shots.paths[contact.point].start, contact.relocation};
        CHECK((r == 0 || soup.distance(way) > 1e-9));  // for r = 0 it ends at the surface
        CHECK(contact.depth <= 2 * 0.05 + 2 * r);      // at most the path length, there and back
      }
    }
  }
}

TEST_CASE("swept: paths aimed at vertices and edges of convex bodies are all in contact") {
  for (const fixtures::Body& body :
       {fixtures::Body{"box", fixtures::box()}, fixtures::Body{"sphere", fixtures::sphere()}, fixtures::Body{"blade", fixtures::blade()}}) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Path> paths;
    for (int trial = 0; trial < 2000; ++trial) {
      const std::size_t t = random() % surface->triangles().size(), e = random() % 3;
      const double along = trial % 2 == 0 ? 0 : unit(random);
      const Vec3d place = surface->corner(t, e) + along * (surface->corner(t, (e + 1) % 3) - surface->corner(t, e));
      const Vec3d out = surface->pseudonormal(t, static_cast<Feature>((along == 0 ? 4 : 1) + e));
      paths.push_back({place + 1e-3 * out, place - 1e-3 * out});
    }
    for (const double r : {0.0, 5e-4}) {
      Swept detector(surface, Unbounded{}, r);
      CHECK(detect(detector, fixtures::points_on(paths)).size() == paths.size());
    }
  }
}

TEST_CASE("swept: points that enter a thin blade are relocated to the side they came from, at steps up to 4 % of the chord") {
  const auto surface = fixtures::surface_of(fixtures::blade());  // chord 0.4 along y, 4 % thick: 0.016 along z
  const fixtures::Soup soup(*surface);
  for (const double step : {0.002 * 0.4, 0.01 * 0.4, 0.02 * 0.4, 0.04 * 0.4}) {
    CAPTURE(step);
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Path> paths;
    while (paths.size() < 400) {
      // from above or below, somewhere over the middle nine tenths, through the surface to any depth, even out at the other side
      const double side = paths.size() % 2 == 0 ? 1 : -1, x = 0.45 * (2 * unit(random) - 1), y = 0.18 * (2 * unit(random) - 1);
      if (4 * x * x + y * y / 0.04 > 0.9) continue;
      const double height = 0.008 * std::sqrt(1 - 4 * x * x - y * y / 0.04);
      const Vec3d start{x, y, side * (height + 0.5 * step * unit(random))};
      const Vec3d end = start + step * normalised(Vec3d{unit(random) - 0.5, unit(random) - 0.5, -1.5 * side});
      if (soup.distance(Path{start, end}) > 1e-9 || soup.inside(start)) continue;
      paths.push_back({start, end});
    }
    for (const double r : {0.0, 1e-3}) {
      std::vector<Path> outside;
      for (const Path& path : paths)
        if (r == 0 || soup.distance(path.start) > r) outside.push_back(path);
      Swept detector(surface, Unbounded{}, r);
      const std::vector<Contact> contacts = detect(detector, fixtures::points_on(outside));
      CHECK(contacts.size() == outside.size());
      std::size_t wrong_side = 0;
      for (const Contact& contact : contacts) wrong_side += (contact.relocation.z > 0) != (outside[contact.point].start.z > 0);
      CHECK(wrong_side == 0);
    }
  }
}

TEST_CASE("swept: a point that ends nearer to the far side of a thin plate is relocated straight above its end") {
  const auto plate = fixtures::surface_of(make_box({.size = {1, 1, 0.01}, .edge_length = 0.25}));
  for (const double r : {0.0, 0.02}) {
    Swept detector(plate, Unbounded{}, r);
    const std::vector<Contact> contacts = detect(detector, fixtures::points_on({{{0.1, 0.13, 0.03}, {0.14, 0.13, -0.004}}}));
    REQUIRE(contacts.size() == 1);
    CHECK(norm(contacts[0].relocation - Vec3d{0.14, 0.13, 0.005 + r}) < 1e-11);  // the offset of 1e-12
  }
}

TEST_CASE("swept: after contact, motion away from the surface and rest on it are not contact, motion along it continues") {
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const fixtures::Shots shots(soup, r, 0.03, 150, 5);
      for (const Pose& pose : {Pose(), Pose({12, -7, 3}, Quaternion::from_rotation({1, 2, 0.5}))}) {
        const Motion rest{pose, pose, 1};
        Swept detector(surface, Unbounded{}, r);
        const std::vector<Contact> contacts = detect(detector, fixtures::points_on(shots.paths, rest), rest);
        REQUIRE(contacts.size() > 25);
        fixtures::TestPoints away, still;
        for (const Contact& contact : contacts) {
          away.x0.push_back(contact.relocation);
          away.x1.push_back(contact.relocation + 1e-4 * contact.normal);
          still.x0.push_back(contact.relocation);
          still.x1.push_back(contact.relocation);
        }
        detector.forget();
        CHECK(detect(detector, away, rest).empty());
        detector.forget();
        CHECK(detect(detector, still, rest).empty());
      }
    }
  }
}

TEST_CASE("swept: a panel that moves or rotates into a resting point is in contact with it") {
  const auto surface = fixtures::surface_of(fixtures::box());  // 1 × 0.6 × 0.4
  fixtures::TestPoints points;
  points.x0 = points.x1 = {{0.505, 0.1, 0.1}, {0, 0.41, 0.1}, {0.505, 0.4, 0}};
  const Motion shift{Pose(), Pose({0.01, 0, 0}), 1};
  Swept shifted(surface, Unbounded{}, 0);
  const std::vector<Contact> by_shift = detect(shifted, points, shift, 0.01);
  REQUIRE(by_shift.size() == 1);
  CHECK(by_shift[0].point == 0);
  CHECK(norm(by_shift[0].relocation - Vec3d{0.51, 0.1, 0.1}) < 1e-11);  // the face, and the offset of 1e-12
  CHECK(by_shift[0].time_fraction == fixtures::relative(0.5, 1e-12));
  CHECK(norm(by_shift[0].normal - Vec3d{1, 0, 0}) < 1e-12);

  // a quarter turn in small steps sweeps the box's corner, 0.583 from the axis, past the positions of the second and third point
  Swept turning(surface, Unbounded{}, 0);
  std::vector<bool> met(3, false);
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {}, {0, 0, 1}, {});
  for (int step = 0; step < 157; ++step) {
    const Motion motion = body.advance(0.01);
    for (const Contact& contact : detect(turning, points, motion, body.travel_bound(motion, 0.62))) met[contact.point] = true;
  }
  CHECK(met[0]);
  CHECK(met[1]);
  CHECK_FALSE(met[2]);  // 0.645 from the axis
}

namespace {

/// Debris moves around and against a rotating hull; points in contact are relocated and rebound by their displacement. Returns all contacts.
std::vector<Contact> debris_run(Swept& detector, double radius_of_surface, int steps, int forget_every) {
  std::mt19937_64 random(12);
  fixtures::TestPoints points;
  for (int i = 0; i < 2000; ++i) {
    points.x1.push_back(fixtures::random_in_box(random, {-1, -1, -1}, {1, 1, 1}));
    points.v.push_back((i % 64 == 0 ? 20 : 0.5) * fixtures::random_direction(random));
  }
  points.x0 = points.x1;
  for (const std::size_t i : detector.initial_overlap(points, Pose())) points.x1[i] = points.x1[i] + Vec3d{3, 0, 0};
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {0.2, -0.1, 0}, {0, 0.3, 2}, {});
  std::vector<Contact> all;
  const double dt = 0.002;
  for (int step = 0; step < steps; ++step) {
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += dt * points.v[i];
    const Motion motion = body.advance(dt);
    if (forget_every > 0 && step % forget_every == 0) detector.forget();
    for (const Contact& contact : detect(detector, points, motion, body.travel_bound(motion, radius_of_surface))) {
      const std::size_t i = contact.point;
      all.push_back(contact);
      points.v[i] += (contact.relocation - points.x1[i]) / dt;
      points.x1[i] = contact.relocation;
    }
  }
  return all;
}

bool same_bits(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& p, const Contact& q) {
    return p.point == q.point && p.panel == q.panel && p.time_fraction == q.time_fraction && p.hit == q.hit && p.normal == q.normal &&
           p.relocation == q.relocation && p.depth == q.depth;
  });
}

}  // namespace

TEST_CASE("swept: results are bitwise identical when all distances are forgotten at any step, and for any number of threads") {
  const auto surface = fixtures::surface_of(fixtures::hull());
  const double radius = surface->radius_about({});
  for (const double r : {0.0, 0.01}) {
    Swept remembering(surface, Unbounded{}, r);
    const fixtures::Threads with_one(1);
    const std::vector<Contact> contacts = debris_run(remembering, radius, 60, 0);
    CHECK(contacts.size() > 50);
    for (const int forget_every : {1, 7}) {
      Swept forgetful(surface, Unbounded{}, r);
      CHECK(same_bits(contacts, debris_run(forgetful, radius, 60, forget_every)));
      CHECK(forgetful.effort().points_tested > remembering.effort().points_tested);
    }
    for (const int count : {2, 4}) {
      const fixtures::Threads with_several(count);
      Swept parallel(surface, Unbounded{}, r);
      CHECK(same_bits(contacts, debris_run(parallel, radius, 60, 0)));
    }
  }
}

TEST_CASE("swept: far points are not evaluated at all, step after step") {
  const auto surface = fixtures::surface_of(fixtures::sphere());
  Swept detector(surface, Unbounded{}, 0.01);
  fixtures::TestPoints points;
  std::mt19937_64 random(13);
  for (int i = 0; i < 6400; ++i) points.x1.push_back(Vec3d{3, 0, 0} + fixtures::random_in_box(random, {-1, -1, -1}, {1, 1, 1}));
  for (int step = 0; step < 1000; ++step) {  // 1 m of path in total, 1.5 m away
    points.x0 = points.x1;
    for (Vec3d& x : points.x1) x.y += 1e-3;
    CHECK(detect(detector, points).empty());
  }
  CHECK(detector.effort().points_tested == 0);
}

TEST_CASE("swept: a point that was displaced externally is evaluated again") {
  const auto surface = fixtures::surface_of(fixtures::sphere());
  Swept detector(surface, Unbounded{}, 0);
  fixtures::TestPoints points;
  points.x0 = points.x1 = {{3, 0, 0}, {0, 3, 0}};
  CHECK(detect(detector, points).empty());
  points.x0[1] = points.x1[1] = {0, 0.6, 0};
  detector.moved(1);
  CHECK(detect(detector, points).empty());
  points.x1[1] = {0, 0.45, 0};
  CHECK(detect(detector, points).size() == 1);
}

TEST_CASE("swept: a point pinched inside is relocated to the nearest position outside") {
  const auto surface = fixtures::surface_of(fixtures::box());
  for (const double r : {0.0, 0.02}) {
    Swept detector(surface, Unbounded{}, r);
    fixtures::TestPoints points;
    points.x0 = points.x1 = {{0.1, 0.05, 0.17}, {0.1, -0.29, 0.05}};
    const std::vector<Contact> contacts = detect(detector, points);
    REQUIRE(contacts.size() == 2);
    CHECK(norm(contacts[0].relocation - Vec3d{0.1, 0.05, 0.2 + r}) < 1e-11);  // the offset is 1e-12
    CHECK(norm(contacts[1].relocation - Vec3d{0.1, -0.3 - r, 0.05}) < 1e-11);
  }
}

TEST_CASE("swept: in concave regions the point ends at the contact radius from everything") {
  // a step: an L profile of two boxes, its inner corner along y at x = z = 0
  Panels step;
  const double profile[6][2] = {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}};
  for (const double y : {-1.0, 1.0})
    for (const auto& p : profile) step.vertices.push_back({p[0], y, p[1]});
  for (int k = 0; k < 6; ++k) step.add_quad(k, 6 + k, 6 + (k + 1) % 6, (k + 1) % 6);
  for (const auto& t : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    step.add_triangle(t[0], t[1], t[2]);
    step.add_triangle(6 + t[0], 6 + t[2], 6 + t[1]);
  }
  const auto surface = fixtures::surface_of(step);
  REQUIRE(surface->is_closed());
  const double r = 0.05;
  Swept detector(surface, Unbounded{}, r);
  const std::vector<Path> paths{{{0.3, 0, 0.3}, {0.01, 0, 0.01}}, {{0.3, 0, 0.3}, {-0.02, 0, -0.03}}, {{0.3, 0, 0.06}, {0.02, 0, 0.04}}};
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on(paths));
  REQUIRE(contacts.size() == 3);
  for (const Contact& contact : contacts) CHECK(norm(contact.relocation - Vec3d{r, 0, r}) < 1e-10);  // a few offsets of 2e-12
}

TEST_CASE("swept: a glancing contact is relocated by no more than its penetration, so that it does not pull") {
  const auto surface = fixtures::surface_of(fixtures::box());  // edge along y at x = 0.5, z = 0.2
  for (const double r : {0.0, 0.02}) {
    for (const double deep : {1e-3, 1e-5, 1e-7}) {
      // across the edge at 45°, nearer than r by `deep`, and out again
      const double out = (r - deep) / std::sqrt(2.0);
      const Vec3d middle{0.5 + out, 0.05, 0.2 + out};
      Swept detector(surface, Unbounded{}, r);
      const std::vector<Contact> contacts = detect(detector, fixtures::points_on({{middle + Vec3d{-0.05, 0, 0.05}, middle + Vec3d{0.05, 0, -0.05}}}));
      REQUIRE(contacts.size() == 1);
      // The remaining path, at most 0.1, times its slope relative to the box: 45° on the face for a point, √(2 deep/r) on the
      // edge for a ball. There the 32 steps of the advancement stop short by r/16, a slope of 1/16.
      CHECK(contacts[0].depth < (r == 0 ? 0.051 : 0.1 * std::sqrt(2 * deep / r) + 0.071 / 15));
      CHECK(contacts[0].relocation.x > 0.5);
    }
  }
}

TEST_CASE("swept: of overlapping closed parts only the outside of their union is surface") {
  // a bar embedded in a box
  const Panels bar = fixtures::moved(make_box({.size = {0.1, 0.1, 1}, .edge_length = 0.1}), [](const Vec3d& p) { return p + Vec3d{0, 0, 0.5}; });
  const auto surface = fixtures::surface_of(fixtures::joined(fixtures::box(), bar));
  const fixtures::Soup box{Surface(fixtures::box())}, rod{Surface(bar)};
  std::mt19937_64 random(14);
  std::vector<Path> paths;
  std::size_t inward = 0;
  while (paths.size() < 2000) {
    const Vec3d start = fixtures::random_in_box(random, {-0.2, -0.2, 0.0}, {0.2, 0.2, 0.5}), end = start + 0.1 * fixtures::random_direction(random);
    if (box.inside(start) || rod.inside(start)) continue;
    const double distance = std::min(box.distance(Path{start, end}), rod.distance(Path{start, end}));
    if (distance > 1e-9 && distance < 1e-6) continue;
    paths.push_back({start, end});
    inward += distance <= 1e-9;
  }
  Swept detector(surface, Unbounded{}, 0);
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on(paths));
  CHECK(contacts.size() == inward);
  for (const Contact& contact : contacts) {
    const Vec3d place = contact.relocation + 1e-9 * contact.normal;
    CHECK_FALSE(box.inside(place));
    CHECK_FALSE(rod.inside(place));
  }
}

TEST_CASE("swept: positions that are not numbers have no contact and do not affect other points") {
  const auto surface = fixtures::surface_of(fixtures::sphere());
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  fixtures::TestPoints points;
  points.x0 = {{nan, 0, 0}, {0, 0, 0.6}, {0.6, 0, 0}, {inf, 0, 0}, {0.6, 0, 0}, {1e300, 0, 0}};
  points.x1 = {{0, 0, 0}, {0, nan, 0}, {0.4, 0, 0}, {0, 0, 0}, {-inf, 0, 0}, {0, 1e300, 0}};
  for (const double r : {0.0, 0.01}) {
    Swept detector(surface, Unbounded{}, r);
    for (int step = 0; step < 3; ++step) {
      const std::vector<Contact> contacts = detect(detector, points);
      REQUIRE(contacts.size() == 1);
      CHECK(contacts[0].point == 2);
    }
  }
}

TEST_CASE("swept: a point that comes to occupy a number that was empty is found once it is reported as moved, with a rigid and with a deforming surface") {
  struct Slots : fixtures::TestPoints {
    std::vector<bool> taken;
    bool occupied(std::size_t i) const { return taken[i]; }
  };
  const Panels panels = make_box({.size = {10, 10, 1}});
  Swept rigid(fixtures::surface_of(panels), Unbounded(), 0.1);
  const auto surface = std::make_shared<DeformingSurface>(Surface(panels));
  Deforming deforming(surface, 0.1);
  const auto contacts = [&](const Slots& points) {
    surface->move(panels.vertices);
    std::vector<DeformingContact> found;
    deforming.detect(points, found);
    std::vector<Contact> with_rigid;
    rigid.detect(points, fixtures::at_rest(), 0, with_rigid);
    return std::pair(with_rigid.size(), found.size());
  };
  Slots points;
  points.x0 = points.x1 = {{0, 0, 3}, {0, 0, 1}};
  points.taken = {true, false};
  CHECK(contacts(points) == std::pair(std::size_t{0}, std::size_t{0}));
  points.taken[1] = true;
  points.x1[1].z = 0.2;
  rigid.moved(1), deforming.moved(1);
  CHECK(contacts(points) == std::pair(std::size_t{1}, std::size_t{1}));
}
