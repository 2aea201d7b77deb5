#include "fccda/detect/nearest_outside.hpp"

#include <doctest/doctest.h>

#include <random>

#include "fccda/detect/all_detectors.hpp"
#include "fccda/detect/scene.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

TEST_CASE("nearest outside: points inside every body end at the contact radius from all triangles, as near as the closest point allows") {
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> coordinate(-0.6, 0.6);
  const Pose pose({0.3, -1, 2}, Quaternion::from_rotation({0.4, -0.2, 0.9}));
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double radius : {0.0, 0.05}) {
      const Swept detector(surface, Unbounded{}, radius);
      fixtures::TestPoints points;
      std::vector<Vec3d> inside;
      while (inside.size() < 60) {
        const Vec3d place{coordinate(random), coordinate(random), coordinate(random)};
        const bool is_inside = soup.inside(place);
        if (!is_inside && !(soup.distance(place) < radius)) continue;
        inside.push_back(place);
        points.x0.push_back(pose.to_world(place));
      }
      points.x1 = points.x0;
      CHECK(detector.initial_overlap(points, pose).size() == inside.size());
      const auto places = detector.nearest_outside(points.x0, pose);
      for (std::size_t k = 0; k < inside.size(); ++k) {
        REQUIRE(places[k].has_value());
        const Vec3d place = pose.to_body(*places[k]);
        CHECK_FALSE(soup.inside(place + 1e-9 * normalised(place - inside[k])));  // at r = 0 the position is on the surface up to rounding
        CHECK(soup.distance(place) >= radius - 1e-9);                            // the interval bisection of the reference, and two rotations
        const double way = norm(place - inside[k]), least = soup.inside(inside[k]) ? radius + soup.distance(inside[k]) : radius - soup.distance(inside[k]);
        CHECK(way >= least - 1e-9);
        if (body.name != std::string("hull") && body.name != std::string("torus")) CHECK(way <= least + 1e-9);  // convex: one projection is enough
        points.x0[k] = *places[k];
      }
      CHECK(detector.initial_overlap(points, pose).empty());
    }
  }
}

TEST_CASE("nearest outside: the analytic sphere relocates points to R + r, and has no position for its centre") {
  const Analytic detector(Sphere{.radius = 0.5}, Unbounded{}, 0.1);
  const Pose pose({1, 2, 3});
  const std::vector<Vec3d> inside = {{1.2, 2, 3.1}, {1, 2, 3}};
  const auto places = detector.nearest_outside(inside, pose);
  REQUIRE(places[0].has_value());
  CHECK(norm(*places[0] - pose.position()) == fixtures::relative(0.6, 1e-10));  // an offset of 1e-12 is added
  CHECK(norm(cross(*places[0] - pose.position(), inside[0] - pose.position())) < 1e-12);
  CHECK_FALSE(places[1].has_value());
}
