// Clipping contact bounds and open surfaces: contact with part of the surface is ignored.
#include <doctest/doctest.h>

#include <random>

#include "fccda/detect/scene.hpp"
#include "fccda/detect/swept.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

/// The paper's cylinder (section 5.1), diameter 50 mm, and contact bounds of the same width, 10 mm thick.
constexpr double R = 0.025, spacing = 0.001;
std::shared_ptr<const Surface> plate_cylinder() {
  return fixtures::surface_of(make_cylinder({.diameter = 2 * R, .height = R, .axis = Axis::z, .edge_length = spacing}));
}
constexpr BoxUnion::Shape plate_box{.size = {2 * R, 2 * R, 0.01}};

/// A square of 1 × 1 in the plane z = 0, front towards +z, of 4 × 4 quads.
std::shared_ptr<const Surface> open_square() {
  Panels square;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) square.vertices.push_back({0.25 * i - 0.5, 0.25 * j - 0.5, 0});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) square.add_quad(5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5);
  return std::make_shared<const Surface>(square, Surface::Options{.orientation = Orientation::normals});
}

struct ListReader {
  std::vector<std::uint64_t> list;
  void operator()(std::string_view name, std::vector<std::uint64_t>& values) {
    if (name == "points_inside") list = values;
  }
  void operator()(std::string_view, std::uint64_t&) {}
};

std::vector<std::uint64_t> points_inside(Swept& detector) {
  ListReader reader;
  detector.visit_state(reader);
  return reader.list;
}

}  // namespace

TEST_CASE("swept, bounds: a box exactly as wide as the cylinder, contact radius half a spacing: points that enter from the side cause no spike") {
  const auto surface = plate_cylinder();
  const double r = 0.5 * spacing, speed = 32, dt = 1e-7;
  Swept detector(surface, BoxUnion(plate_box, *surface, Beyond::clip), r);
  // points from every direction around, the four sides of the box among them, each straight at the axis
  fixtures::TestPoints points;
  for (int k = 0; k < 720; ++k) {
    const double angle = k * std::numbers::pi / 360;
    points.x1.push_back({(R + r + 2e-6) * std::cos(angle), (R + r + 2e-6) * std::sin(angle), 0.004 * std::sin(7.0 * k)});
    points.v.push_back(-speed * Vec3d{std::cos(angle), std::sin(angle), 0});
  }
  std::vector<std::size_t> contacts_of(points.x1.size(), 0);
  for (int step = 0; step < 20; ++step) {
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += dt * points.v[i];
    for (const Contact& contact : detect(detector, points)) {
      ++contacts_of[contact.point];
      CHECK(contact.depth <= 1.01 * speed * dt);  // never relocated by more than its motion; a spike is r and more
      points.x1[contact.point] = contact.relocation;
      points.v[contact.point] = {};
    }
  }
  for (const std::size_t count : contacts_of) CHECK(count == 1);
  CHECK(detector.entered_inside() == 0);
}

TEST_CASE("swept, bounds: a point that enters clipping bounds inside the surface is counted once and without contact until it has left") {
  const auto surface = plate_cylinder();
  for (const double r : {0.0, 0.5 * spacing}) {
    CAPTURE(r);
    Swept detector(surface, BoxUnion(plate_box, *surface, Beyond::clip), r);
    fixtures::TestPoints points;
    points.x1 = {{R - 0.004, 0, 0.008}};
    const auto go = [&](const Vec3d& way, int steps) {
      std::size_t contacts = 0;
      for (int step = 0; step < steps; ++step) {
        points.x0 = points.x1;
        points.x1[0] += way;
        const std::vector<Contact> found = detect(detector, points);
        contacts += found.size();
        if (!found.empty()) points.x1[0] = found[0].relocation;
      }
      return contacts;
    };
    CHECK(go({0, 0, -1e-4}, 80) == 0);  // down into the bounds, inside the cylinder
    CHECK(detector.entered_inside() == 1);
    CHECK(go({1e-4, 0, 0}, 60) == 0);  // outward through the surface
    CHECK(points.x1[0].x > R + r);
    CHECK(points_inside(detector).empty());
    CHECK(go({-1e-4, 0, 0}, 60) > 0);  // and back: contact
    CHECK(points.x1[0].x > R - 1e-4);
    CHECK(detector.entered_inside() == 1);
  }
}

TEST_CASE("swept, bounds: a point inside counts as entered where it enters, even if its nearest panel is within the bounds") {
  // A diamond with an edge at x = -√½; the bounds begin at x = -0.3. A point inside at x = -0.28, 0.1 below the upper panels there, has its
  // nearest surface point at x = -0.35, which is in the bounds.
  const double quarter = std::numbers::pi / 4;
  const auto surface = fixtures::surface_of(fixtures::moved(make_box({.size = {1, 1, 1}, .edge_length = 0.25}), [&](const Vec3d& p) {
    return Vec3d{std::cos(quarter) * p.x + std::sin(quarter) * p.z, p.y, -std::sin(quarter) * p.x + std::cos(quarter) * p.z};
  }));
  const Vec3d start = Vec3d{-0.35, 0.01, std::sqrt(0.5) - 0.35} - 0.1 * Vec3d{-std::sqrt(0.5), 0, std::sqrt(0.5)};
  REQUIRE(start.x > -0.3);
  CHECK(fixtures::Soup(*surface).distance(start) == fixtures::relative(0.1, 1e-12));
  Swept detector(surface, BoxUnion({.size = {0.7, 2, 3}, .centre = {-0.65, 0, 0}}, *surface, Beyond::clip), 0);
  CHECK(detect(detector, fixtures::points_on({{start, start + Vec3d{-0.04, 0, 0}}})).empty());
  CHECK(detector.entered_inside() == 1);
}

TEST_CASE("swept, bounds: beyond the bounds there is no contact, and points that entered there have none inside the bounds") {
  const auto surface = plate_cylinder();
  for (const double r : {0.0, 0.5 * spacing}) {
    CAPTURE(r);
    Swept detector(surface, BoxUnion(plate_box, *surface, Beyond::clip), r);
    fixtures::TestPoints points;
    points.x1 = {{R + 0.001, 0, 0.0052}};
    std::size_t contacts = 0;
    for (int step = 0; step < 40; ++step) {
      points.x0 = points.x1;
      points.x1[0] += step < 20 ? Vec3d{-1e-4, 0, 0} : Vec3d{0, 0, -1e-4};
      contacts += detect(detector, points).size();
    }
    CHECK(contacts == 0);
    CHECK(detector.entered_inside() == 1);
  }
}

TEST_CASE("swept, bounds: the list of points inside is state: restored, it continues identically") {
  const auto surface = plate_cylinder();
  const BoxUnion region(plate_box, *surface, Beyond::clip);
  Swept first(surface, region, 0), second(surface, region, 0);
  fixtures::TestPoints points;
  points.x0 = {{R - 0.004, 0, 0.0051}};
  points.x1 = {{R - 0.004, 0, 0.0049}};
  CHECK(detect(first, points).empty());
  std::vector<std::uint64_t> list = points_inside(first);
  CHECK(list == std::vector<std::uint64_t>{0});
  CHECK(first.entered_inside() == 1);
  struct Writer {
    std::vector<std::uint64_t>& list;
    void operator()(std::string_view name, std::vector<std::uint64_t>& values) {
      if (name == "points_inside") values = list;
    }
    void operator()(std::string_view, std::uint64_t&) {}
  } writer{list};
  second.visit_state(writer);
  points.x0 = points.x1;
  CHECK(detect(first, points).empty());
  CHECK(detect(second, points).empty());
  Swept ignorant(surface, region, 0);
  CHECK(detect(ignorant, points).size() == 1);  // so the list suppressed the contact of the others
}

TEST_CASE("swept, bounds: a point that entered is not expelled after points were renumbered, nor counted again, and contact resumes") {
  const auto surface = plate_cylinder();
  for (const double r : {0.0, 0.5 * spacing}) {
    CAPTURE(r);
    Swept detector(surface, BoxUnion(plate_box, *surface, Beyond::clip), r);
    fixtures::TestPoints points;
    points.x1 = {{0, R + r + 5e-5, 0}, {1, 1, 1}, {R - 0.004, 0, 0.008}};
    const auto step = [&](const Vec3d& way, std::size_t wanderer, std::size_t pusher) {  // returns the wanderer's contacts
      points.x0 = points.x1;
      points.x1[wanderer] += way;
      points.x1[pusher].y -= 1e-4;
      const std::vector<Contact> found = detect(detector, points);
      for (const Contact& contact : found) points.x1[contact.point] = contact.relocation;
      CHECK(std::count_if(found.begin(), found.end(), [&](const Contact& contact) { return contact.point == pusher; }) == 1);
      return std::count_if(found.begin(), found.end(), [&](const Contact& contact) { return contact.point == wanderer; });
    };
    for (int k = 0; k < 80; ++k) CHECK(step({0, 0, -1e-4}, 2, 0) == 0);
    CHECK(points_inside(detector) == std::vector<std::uint64_t>{2});
    std::swap(points.x1[1], points.x1[2]);
    detector.renumbered();
    for (int k = 0; k < 20; ++k) CHECK(step({1e-4, 0, 0}, 1, 0) == 0);
    CHECK(points_inside(detector) == std::vector<std::uint64_t>{1});
    CHECK(detector.entered_inside() == 1);
    std::swap(points.x1[0], points.x1[1]);
    detector.renumbered();
    for (int k = 0; k < 40; ++k) CHECK(step({1e-4, 0, 0}, 0, 1) == 0);
    CHECK(points_inside(detector).empty());  // it is out
    std::ptrdiff_t contacts = 0;
    for (int k = 0; k < 60; ++k) contacts += step({-1e-4, 0, 0}, 0, 1);
    CHECK(contacts > 0);
    CHECK(detector.entered_inside() == 1);
  }
}

TEST_CASE("swept, bounds: the number of a removed point that had entered does not exempt the next point with this number") {
  const auto surface = plate_cylinder();
  Swept detector(surface, BoxUnion(plate_box, *surface, Beyond::clip), 0);
  const Path far{{1, 1, 1}, {1, 1, 1}};
  CHECK(detect(detector, fixtures::points_on({far, {{R - 0.004, 0, 0.0051}, {R - 0.004, 0, 0.0049}}})).empty());
  CHECK(points_inside(detector) == std::vector<std::uint64_t>{1});
  CHECK(detect(detector, fixtures::points_on({far})).empty());
  CHECK(points_inside(detector).empty());
  CHECK(detect(detector, fixtures::points_on({far, {{R - 1e-6, 0, 0}, {R - 1e-4, 0, 0}}})).size() == 1);
}

TEST_CASE("swept, open: points that come round the boundary, or cross it with their centre, count as entered and are not expelled, renumbered or not") {
  const double r = 0.02, pace = 1e-3;
  for (const bool renumbers : {false, true}) {
    CAPTURE(renumbers);
    Swept detector(open_square(), Unbounded{}, r);
    fixtures::TestPoints points;
    points.x0 = {{0.505, 0.1, 0.004}, {0.52, 0.2, 0.005}};
    points.x1 = {{0.485, 0.1, -0.004}, {0.519, 0.2, 0.005}};  // the first crosses the panel from beyond the boundary
    std::vector<Contact> contacts = detect(detector, points);
    REQUIRE(contacts.size() == 1);
    points.x1[0] = contacts[0].relocation;
    CHECK(points.x1[0].z < 1e-6);
    for (int k = 0; k < 60; ++k) {
      points.x0 = points.x1;
      for (Vec3d& x : points.x1) x.x -= pace;
      if (renumbers && k == 40) {
        std::swap(points.x0[0], points.x0[1]), std::swap(points.x1[0], points.x1[1]);
        detector.renumbered();
      }
      CHECK(detect(detector, points).empty());
    }
    CHECK(detector.entered_inside() == 2);
    CHECK(points_inside(detector) == std::vector<std::uint64_t>{0, 1});
  }
}

TEST_CASE("swept, open: a point in contact in a step is in contact in a repeated detection, however short its path has become") {
  // It starts 0.005 too near, which its path of 0.01 explains and one of 1e-4 does not.
  const double r = 0.02;
  Swept detector(open_square(), Unbounded{}, r);
  fixtures::TestPoints points = fixtures::points_on({{{0.1, 0.2, 0.015}, {0.1, 0.2, 0.005}}});
  CHECK(detect(detector, points).size() == 1);
  points.x1[0].z = 0.0149;
  std::vector<Contact> contacts;
  detector.detect_again(points, fixtures::at_rest(), 0, std::vector<std::size_t>{0}, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK(std::fabs(contacts[0].relocation.z - r) < 1e-11);
  CHECK(detector.entered_inside() == 0);
}

TEST_CASE("swept, open: contact from the front, free passage from behind") {
  const auto square = open_square();
  for (const double r : {0.0, 0.02}) {
    CAPTURE(r);
    const std::vector<Path> paths{{{0.1, 0.2, 0.05}, {0.1, 0.2, -0.01}}, {{0.1, 0.2, -0.05}, {0.1, 0.2, 0.05}}, {{0.1, 0.2, -0.05}, {0.1, 0.2, -0.001}},
                                  {{0.1, 0.2, 0.1}, {0.1, 0.2, 0.05}},   {{0.7, 0.2, 0.05}, {0.7, 0.2, -0.05}}, {{0.25, 0.25, 0.05}, {0.25, 0.25, -0.05}}};
    Swept detector(square, Unbounded{}, r);
    const std::vector<Contact> contacts = detect(detector, fixtures::points_on(paths));
    REQUIRE(contacts.size() == 2);
    CHECK(contacts[0].point == 0);
    CHECK(contacts[1].point == 5);  // at a vertex
    CHECK(norm(contacts[0].relocation - Vec3d{0.1, 0.2, r}) < 1e-11);
  }
}

TEST_CASE("swept, open: no step round the boundary, sliding or falling causes a spike, and contact with the front resumes after a point has left it") {
  const auto square = open_square();
  const double r = 0.02, pace = 1e-3;
  Swept detector(square, Unbounded{}, r);
  std::mt19937_64 random(15);
  fixtures::TestPoints points;
  for (int i = 0; i < 500; ++i) points.x1.push_back(fixtures::random_in_box(random, {-0.55, -0.55, -0.03}, {0.55, 0.55, 0.03}));
  points.x0 = points.x1;
  for (const std::size_t i : detector.initial_overlap(points, Pose())) points.x1[i].z += 0.1;
  for (const Vec3d& x : points.x1) points.v.push_back(pace * normalised(fixtures::random_direction(random) - 0.5 * x));
  std::size_t contacts = 0;
  for (int step = 0; step < 300; ++step) {
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += points.v[i];
    for (const Contact& contact : detect(detector, points)) {
      ++contacts;
      CHECK(contact.depth <= 2.1 * pace);
      CHECK(contact.relocation.z > 0);
      points.x1[contact.point] = contact.relocation;
    }
  }
  CHECK(contacts > 1000);
  CHECK(detector.entered_inside() > 0);
}

TEST_CASE("swept: the points that start inside agree with winding number and distance, and contact is not inside") {
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    std::mt19937_64 random(16);
    const Pose pose({1, 2, 3}, Quaternion::from_rotation({0.3, 2, -1}));
    for (const double r : {0.0, 0.03}) {
      fixtures::TestPoints points;
      std::vector<std::size_t> truth;
      while (points.x0.size() < 300) {
        const Vec3d point = fixtures::random_in_box(random, {-0.6, -0.6, -0.3}, {0.6, 0.6, 0.3});
        const bool inside = soup.inside(point);
        const double distance = soup.distance(point);
        if (std::fabs(distance - r) < 1e-6) continue;
        if (inside || distance < r) truth.push_back(points.x0.size());
        points.x0.push_back(pose.to_world(point));
      }
      CHECK(Swept(surface, Unbounded{}, r).initial_overlap(points, pose) == truth);
      fixtures::TestPoints touching;
      for (std::size_t t = 0; t < surface->triangles().size(); ++t) {
        const Vec3d middle = (surface->corner(t, 0) + surface->corner(t, 1) + surface->corner(t, 2)) / 3;
        const Vec3d place = middle + r * surface->normal(t);
        if (soup.distance(place) > r - 1e-12) touching.x0.push_back(pose.to_world(place));
      }
      CHECK(Swept(surface, Unbounded{}, r).initial_overlap(touching, pose).empty());
    }
  }
}
