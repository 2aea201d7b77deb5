#include "fccda/deforming/deforming.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "fccda/deforming/scenes.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

namespace {

/// The vertices of these panels, displaced.
std::vector<Vec3d> along_x(const Panels& panels, double way) {
  std::vector<Vec3d> vertices = panels.vertices;
  for (Vec3d& x : vertices) x.x += way;
  return vertices;
}

}  // namespace

TEST_CASE("deforming: of points on random paths exactly those are in contact that cross the moving surface") {
  std::mt19937_64 random(11);
  std::size_t contacts = 0, missed = 0, invented = 0, behind = 0;
  double worst = 0;
  for (const fixtures::Body& body : fixtures::bodies())
    for (const Deformation& deformation : deformations()) {
      const auto surface = std::make_shared<DeformingSurface>(Surface(body.panels));
      surface->move(displaced(body.panels, deformation, 0.01));
      surface->move(displaced(body.panels, deformation, 0.04));  // up to a panel's size in the step
      const Soup at_t0(surface->at_t0()), at_t1(surface->at_t1());
      TestPoints points;
      std::vector<exact::Answer> crossing;
      while (points.size() < 120) {
        const Path path = path_near(*surface, 0.05, 0.15, random);
        if (at_t0.inside(path.start)) continue;
        const exact::Answer answer = Near(*surface, path, 0).crossing(path);
        if (answer.margin < 1e-12) continue;  // undecided in double precision
        points.x0.push_back(path.start), points.x1.push_back(path.end);
        crossing.push_back(answer);
      }
      Deforming detector(surface, 0);
      std::map<std::size_t, DeformingContact> found;
      for (const DeformingContact& contact : deforming::detect(detector, points)) found[contact.contact.point] = contact;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const bool expected = crossing[i].crosses, is_found = found.count(i) > 0;
        contacts += expected, missed += expected && !is_found, invented += !expected && is_found;
        if (!expected || !is_found) continue;
        const Contact& contact = found[i].contact;
        worst = fixtures::larger(worst, std::fabs(contact.time_fraction - crossing[i].time));
        behind += at_t1.inside(contact.relocation + 1e-7 * contact.normal);
        CHECK(at_t1.distance(contact.relocation) < 0.2);
      }
    }
  CHECK(contacts > 800);
  CHECK(missed == 0);
  CHECK(invented == 0);
  CHECK(behind == 0);
  CHECK(worst < 1e-7);
}

TEST_CASE("deforming: of balls on random paths exactly those are in contact that come nearer than their radius") {
  std::mt19937_64 random(12);
  constexpr double radius = 0.03;
  std::size_t contacts = 0, missed = 0, invented = 0, near = 0;
  for (const fixtures::Body& body : fixtures::bodies())
    for (const Deformation& deformation : deformations()) {
      const auto surface = std::make_shared<DeformingSurface>(Surface(body.panels));
      surface->move(displaced(body.panels, deformation, 0.01));
      surface->move(displaced(body.panels, deformation, 0.04));
      const Soup at_t0(surface->at_t0()), at_t1(surface->at_t1());
      TestPoints points;
      std::vector<bool> touches;
      while (points.size() < 60) {
        const Path path = path_near(*surface, 0.1, 0.1, random);
        if (at_t0.distance(path.start) < radius + 1e-6 || at_t0.inside(path.start)) continue;
        const Near triangles(*surface, path, radius + 1e-6);
        const bool surely = triangles.comes_within(path, radius - 1e-6);
        if (!surely && triangles.comes_within(path, radius + 1e-6)) continue;
        points.x0.push_back(path.start), points.x1.push_back(path.end);
        touches.push_back(surely);
      }
      Deforming detector(surface, radius);
      std::vector<bool> found(points.size());
      for (const DeformingContact& contact : deforming::detect(detector, points)) {
        found[contact.contact.point] = true;
        near += at_t1.distance(contact.contact.relocation) < radius - 1e-9 || at_t1.inside(contact.contact.relocation);
      }
      for (std::size_t i = 0; i < points.size(); ++i) contacts += touches[i], missed += touches[i] && !found[i], invented += !touches[i] && found[i];
    }
  CHECK(contacts > 400);
  CHECK(missed == 0);
  CHECK(invented == 0);
  CHECK(near == 0);
}

TEST_CASE("deforming: a surface whose vertices move rigidly has the contacts of the rigid surface") {
  std::mt19937_64 random(13);
  // Arcs and chords differ by θ w/4 = 2.5e-7 for a turn θ of 1e-5 and a path w of 0.1, so that contact on grazing paths is met at other times.
  struct Tolerance {
    double turn, time, place, normal;
  };
  std::size_t contacts = 0, panels = 0;
  for (const auto& [radius, tolerance] : {std::pair(0.0, Tolerance{0, 1e-9, 1e-9, 1e-8}), std::pair(0.03, Tolerance{0, 1e-9, 1e-9, 1e-8}),
                                          std::pair(0.0, Tolerance{1e-5, 1e-3, 1e-4, 1e-3}), std::pair(0.03, Tolerance{1e-5, 1e-3, 1e-4, 1e-3})})
    for (const fixtures::Body& body : fixtures::bodies()) {
      const auto rigid = fixtures::surface_of(body.panels);
      const auto surface = std::make_shared<DeformingSurface>(*rigid);
      const Motion motion{
          Pose({0.1, 0.2, -0.3}, Quaternion::from_rotation({0.3, 0.1, 0.2}).normalised()),
          Pose({0.15, 0.18, -0.27}, (Quaternion::from_rotation({tolerance.turn, 0, 0}) * Quaternion::from_rotation({0.3, 0.1, 0.2})).normalised()), 1};
      const auto at = [&](const Pose& pose) {
        std::vector<Vec3d> out;
        for (const Vec3d& x : body.panels.vertices) out.push_back(pose.to_world(x));
        return out;
      };
      surface->move(at(motion.t0));
      surface->move(at(motion.t1));
      const Soup at_t0(surface->at_t0());
      TestPoints points;
      while (points.size() < 400) {
        const Path path = path_near(*surface, radius + 0.05, 0.1, random);
        if (at_t0.distance(path.start) < radius + 1e-6 || at_t0.inside(path.start)) continue;
        points.x0.push_back(path.start), points.x1.push_back(path.end);
      }
      Swept swept(rigid, Unbounded(), radius);
      Deforming deforming(surface, radius);
      const std::vector<Contact> expected = fixtures::detect(swept, points, motion, surface->travel());
      const std::vector<DeformingContact> found = deforming::detect(deforming, points);
      const auto distance_from = [&](int panel, const Vec3d& place) {
        double least = 1e300;
        for (std::size_t t = 0; t < rigid->triangles().size(); ++t) {
          const Corners c = surface->triangle(t).t1;
          if (rigid->triangles()[t].panel == panel) least = std::min(least, Soup::distance(place, {c.a, c.b, c.c}));
        }
        return least;
      };
      REQUIRE(found.size() == expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        const Contact &a = expected[k], &b = found[k].contact;
        REQUIRE(a.point == b.point);
        ++contacts, panels += a.panel == b.panel;
        if (a.panel != b.panel) {
          // At an edge or vertex rounding decides which of its panels is the closest, to the relocated point, or to the end of a path that ends outside.
          const auto differ = [&](const Vec3d& place) { return std::fabs(distance_from(a.panel, place) - distance_from(b.panel, place)); };
          CHECK(std::min(differ(b.relocation), differ(points.x1[a.point])) < tolerance.place);
        }
        CHECK(a.time_fraction == fixtures::absolute(b.time_fraction, tolerance.time, "1"));
        CHECK(norm(a.relocation - b.relocation) == fixtures::absolute(0, tolerance.place, "m"));
        CHECK(norm(a.hit - b.hit) == fixtures::absolute(0, tolerance.place, "m"));
        CHECK(norm(a.normal - b.normal) == fixtures::absolute(0, tolerance.normal, "1"));
        CHECK(norm(a.normal_t0 - b.normal_t0) == fixtures::absolute(0, tolerance.normal, "1"));
      }
    }
  CHECK(contacts > 2000);
  CHECK(panels > 0.98 * static_cast<double>(contacts));
}

TEST_CASE("deforming: points cross an open sheet from its front, also where it moves many panels a step and through itself") {
  const Panels flat = sheet(20);
  const auto wave = [](const Vec3d& x, double s) { return Vec3d{x.x * (1 - 1.5 * s), x.y + 0.3 * s * std::sin(9 * x.x), x.z + s * std::cos(7 * x.x + 3 * s)}; };
  std::mt19937_64 random(14);
  std::size_t contacts = 0, missed = 0, invented = 0;
  // In the last case the sheet is turned inside out in the middle of the step, and its halves pass through each other.
  for (const auto& [from, to] : {std::pair(0.0, 0.05), std::pair(0.1, 0.4), std::pair(0.2, 0.9)}) {
    const auto surface = open_surface(flat);
    surface->move(displaced(flat, {"", wave}, from));
    surface->move(displaced(flat, {"", wave}, to));
    TestPoints points;
    std::vector<exact::Answer> crossing;
    while (points.size() < 400) {
      const Path path = path_near(*surface, 0.1, 0.3, random);
      const exact::Answer answer = Near(*surface, path, 0).crossing(path);
      if (answer.margin < 1e-12) continue;
      points.x0.push_back(path.start), points.x1.push_back(path.end);
      crossing.push_back(answer);
    }
    Deforming detector(surface, 0);
    std::vector<bool> found(points.size());
    for (const DeformingContact& contact : deforming::detect(detector, points)) {
      const std::size_t i = contact.contact.point;
      found[i] = true;
      if (crossing[i].crosses) CHECK(contact.contact.time_fraction == fixtures::absolute(crossing[i].time, 1e-7, "1"));
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      contacts += crossing[i].crosses, missed += crossing[i].crosses && !found[i], invented += !crossing[i].crosses && found[i];
  }
  CHECK(contacts > 200);
  CHECK(missed == 0);
  CHECK(invented == 0);
}

namespace {

/// Points in random motion about a body that is bent and twisted to and fro by up to a panel's size a step. They are relocated, and remain where they are put.
struct Swarm {
  Panels panels = fixtures::hull();
  std::shared_ptr<DeformingSurface> surface = std::make_shared<DeformingSurface>(Surface(panels));
  TestPoints points;
  std::mt19937_64 random{15};
  double step;

  Swarm(double radius, double length) : step(length) {
    const Soup soup(surface->at_t1());
    while (points.size() < 500) {
      const Vec3d place = path_near(*surface, radius + 0.06, 0, random).start;
      if (soup.distance(place) < radius + 1e-6 || soup.inside(place)) continue;
      points.x0.push_back(place), points.x1.push_back(place);
    }
  }

  void advance(int k) {
    surface->move(displaced(displaced_panels(k), deformations()[4], 0.02 * std::sin(0.7 * k)));
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i)  // most of them slowly
      points.x1[i] += (i % 5 == 0 ? step : 0.02 * step) * fixtures::random_direction(random);
  }
  void relocate(const std::vector<DeformingContact>& contacts) {
    for (const DeformingContact& contact : contacts) points.x1[contact.contact.point] = contact.contact.relocation;
  }

 private:
  Panels displaced_panels(int k) const {
    Panels out = panels;
    out.vertices = displaced(panels, deformations()[1], 0.03 * std::sin(0.5 * k));
    return out;
  }
};

}  // namespace

TEST_CASE("deforming: in many steps no point gets inside a body that bends and twists by a panel's size a step") {
  for (const double radius : {0.0, 0.03}) {
    Swarm swarm(radius, 0.1);
    Deforming detector(swarm.surface, radius);
    std::size_t contacts = 0, inside = 0;
    for (int k = 1; k <= 40; ++k) {
      swarm.advance(k);
      const std::vector<DeformingContact> found = deforming::detect(detector, swarm.points);
      swarm.relocate(found);
      contacts += found.size();
      const Soup soup(swarm.surface->at_t1());
      if (k % 10 != 0) continue;
      for (const Vec3d& x : swarm.points.x1) {
        const double distance = soup.distance(x);
        inside += distance < radius - 1e-9 || (distance > 1e-9 && soup.inside(x));
      }
    }
    CHECK(contacts > 500);
    CHECK(inside == 0);
  }
}

TEST_CASE("deforming: skipped points and the number of threads change no contact") {
  const auto all_contacts = [](bool forgets, int threads) {
    const fixtures::Threads with_several(threads);
    Swarm swarm(0.03, 0.02);
    Deforming detector(swarm.surface, 0.03);
    std::vector<DeformingContact> all;
    for (int k = 1; k <= 40; ++k) {
      swarm.advance(k);
      if (forgets) detector.forget();
      const std::vector<DeformingContact> found = deforming::detect(detector, swarm.points);
      swarm.relocate(found);
      all.insert(all.end(), found.begin(), found.end());
    }
    return std::pair(all, detector.effort().points_tested);
  };
  const auto [cached, few] = all_contacts(false, 1);
  const auto [fresh, many] = all_contacts(true, 2);
  CHECK(cached.size() > 300);
  CHECK(few < many);
  REQUIRE(cached.size() == fresh.size());
  for (std::size_t k = 0; k < cached.size(); ++k) {
    CHECK(cached[k].contact.point == fresh[k].contact.point);
    CHECK(cached[k].contact.relocation == fresh[k].contact.relocation);
    CHECK(cached[k].contact.time_fraction == fresh[k].contact.time_fraction);
    CHECK(cached[k].place.vertices == fresh[k].place.vertices);
  }
}

TEST_CASE("deforming: points that others displaced in the step are detected again") {
  const Panels cube = fixtures::unit_cube();
  const auto surface = std::make_shared<DeformingSurface>(Surface(cube));
  surface->move(cube.vertices);
  TestPoints points;
  points.x0 = {{2, 0.5, 0.5}, {3, 0.5, 0.5}}, points.x1 = points.x0;
  Deforming detector(surface, 0.1);
  CHECK(deforming::detect(detector, points).empty());
  points.x1[1] = {0.9, 0.5, 0.5};
  std::vector<DeformingContact> again;
  detector.detect_again(points, std::vector<std::size_t>{1}, again);
  REQUIRE(again.size() == 1);
  CHECK(again[0].contact.point == 1);
  CHECK(again[0].contact.relocation.x == fixtures::relative(1.1, 1e-9));
  CHECK(detector.still_inside(points, std::vector<std::size_t>{0, 1}) == std::vector<std::size_t>{1});
  CHECK(detector.initial_overlap(points).empty());
}

TEST_CASE("deforming: a detection needs a step of the surface, and a radius that is a number") {
  const Panels cube = fixtures::unit_cube();
  const auto surface = std::make_shared<DeformingSurface>(Surface(cube));
  surface->move(cube.vertices);
  TestPoints points;
  points.x0 = {{2, 0.5, 0.5}}, points.x1 = points.x0;
  Deforming detector(surface, 0), other(surface, 0);
  deforming::detect(detector, points);
  deforming::detect(other, points);  // another body's
  CHECK_THROWS_WITH_AS(deforming::detect(detector, points),
                       "contact: the deforming surface was not moved since the last detection; call move() once in each step, even if it is at rest.",
                       InputError);
  CHECK_THROWS_WITH_AS(Deforming(surface, -1), "contact: the contact radius is -1 m, but it must be a number of at least 0; 0 is for points without extent.",
                       InputError);
}

TEST_CASE("deforming: a point that the surface was placed beside, and then moved over, is in contact") {
  const Panels cube = fixtures::unit_cube();
  const auto surface = std::make_shared<DeformingSurface>(Surface(cube));
  TestPoints points;
  points.x0 = {{2, 0.4, 0.5}}, points.x1 = points.x0;
  Deforming detector(surface, 0);
  surface->move(along_x(cube, 0.001));
  CHECK(deforming::detect(detector, points).empty());  // its distance of nearly 1 is known now
  surface->place(along_x(cube, 0.99));
  surface->move(along_x(cube, 1.01));
  CHECK(deforming::detect(detector, points).size() == 1);
}

TEST_CASE("deforming: a step of the surface without a detection is noticed") {
  const Panels cube = fixtures::unit_cube();
  const auto surface = std::make_shared<DeformingSurface>(Surface(cube));
  const auto move = [&](double way) { surface->move(along_x(cube, way)); };
  TestPoints points;
  points.x0 = {{2, 0.4, 0.5}}, points.x1 = points.x0;
  Deforming detector(surface, 0);
  move(0);
  CHECK(deforming::detect(detector, points).empty());  // its distance of 1 is known now
  move(0.9);
  move(1.2);  // a travel of 0.3
  CHECK(deforming::detect(detector, points).size() == 1);
}

TEST_CASE("deforming: positions that are not numbers have no contact and do not affect other points") {
  const Panels ball = fixtures::sphere();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  TestPoints points;
  points.x0 = {{nan, 0, 0}, {0, 0, 0.6}, {0.6, 0, 0}, {inf, 0, 0}, {0.6, 0, 0}, {1e300, 0, 0}};
  points.x1 = {{0, 0, 0}, {0, nan, 0}, {0.4, 0, 0}, {0, 0, 0}, {-inf, 0, 0}, {0, 1e300, 0}};
  for (const double r : {0.0, 0.01}) {
    const auto surface = std::make_shared<DeformingSurface>(Surface(ball));
    Deforming detector(surface, r);
    for (int step = 0; step < 3; ++step) {
      surface->move(ball.vertices);
      const std::vector<DeformingContact> contacts = detect(detector, points);
      REQUIRE(contacts.size() == 1);
      CHECK(contacts[0].contact.point == 2);
    }
  }
}
