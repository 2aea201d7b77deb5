#include "fccda/deforming/deforming.hpp"

#include <doctest/doctest.h>

#include <map>

#include "fccda/deforming/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

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
        worst = std::max(worst, std::fabs(contact.time_fraction - crossing[i].time));
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
