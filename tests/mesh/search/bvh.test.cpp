#include "mesh/search/bvh.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <span>

#include "fccda/detect/scene.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

/// Small panels beside a triangle ten thousand times their size.
Panels huge_among_small() {
  const Panels small = fixtures::moved(fixtures::sphere(), [](const Vec3d& p) { return 0.02 * p + Vec3d{-0.5, -0.5, -0.5}; });
  const Panels huge = fixtures::moved(fixtures::tetrahedron(), [](const Vec3d& p) { return 20.0 * p; });
  return fixtures::joined(small, huge);
}

std::vector<fixtures::Body> meshes() {
  std::vector<fixtures::Body> all = fixtures::bodies();
  all.push_back({"huge among small", huge_among_small()});
  all.push_back({"far from the origin", fixtures::moved(fixtures::hull(), [](const Vec3d& p) { return p + Vec3d{1000, -2000, 500}; })});
  all.push_back({"one leaf", fixtures::tetrahedron()});
  return all;
}

}  // namespace

TEST_CASE("bvh: the closest point agrees with a loop over every triangle, near, far, on panels, edges and vertices") {
  for (const fixtures::Body& body : meshes()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    const fixtures::Soup soup(surface);
    const Box& bounds = surface.report().bounds;
    // rounding of coordinates, of distances, and of the reference's normal equations on slivers
    const double tolerance = 1e-12 * (largest_magnitude(bounds.low) + largest_magnitude(bounds.high));
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 300; ++trial) {
      const double away = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 0.01 : 30;
      Vec3d point = fixtures::random_in_box(random, bounds.low, bounds.high);
      if (trial % 4 == 0) point = surface.vertices()[random() % surface.vertices().size()];
      point += away * fixtures::random_direction(random);
      const double truth = soup.distance(point);
      const std::optional<ClosestPoint> closest = bvh.closest(point);
      REQUIRE(closest);
      CHECK(std::fabs(closest->distance - truth) <= tolerance + 1e-14 * truth);
      CHECK(norm(point - closest->point) == closest->distance);
      CHECK(bvh.closest(point, truth + 2 * tolerance + 1e-13 * truth));
      CHECK_FALSE(bvh.closest(point, truth - 2 * tolerance - 1e-13 * truth));
    }
  }
}

TEST_CASE("bvh: results are bitwise identical for any guess") {
  const Surface surface(fixtures::hull());
  const Bvh bvh(surface);
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3d point = fixtures::random_in_box(random, {-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3});
    std::size_t tested = 0;
    const auto plain = bvh.closest(point, Bvh::no_cap, -1, tested);
    const auto guessed = bvh.closest(point, Bvh::no_cap, static_cast<int>(random() % surface.triangles().size()), tested);
    REQUIRE((plain && guessed));
    CHECK(plain->triangle == guessed->triangle);
    CHECK(plain->point == guessed->point);
  }
}

TEST_CASE("bvh: results with cached surroundings are bitwise identical, and save the traversal of the tree") {
  std::size_t from_nearby = 0, walked = 0;
  for (const fixtures::Body& body : meshes()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    const Box& bounds = surface.report().bounds;
    std::mt19937_64 random(16);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
      // reaches from a fraction of a panel to many of them, where the list of leaves overflows; ends within, at the limit and beyond
      const double reach = std::pow(10, -4 + 4 * unit(random)) * largest_magnitude(bounds.size());
      const Vec3d centre = trial % 2 == 0 ? fixtures::random_in_box(random, bounds.low, bounds.high) : surface.vertices()[random() % surface.vertices().size()];
      std::size_t tested = 0;
      Bvh::Nearby nearby;
      const std::optional<ClosestPoint> at_centre = bvh.closest(centre, Bvh::no_cap, -1, reach, nearby, tested);
      REQUIRE(at_centre);
      CHECK(at_centre->point == bvh.closest(centre)->point);
      for (const double share : {0.0, 0.5, 0.98, 1.02, 3.0}) {
        const Vec3d point = centre + share * reach * fixtures::random_direction(random);
        const ClosestPoint truth = *bvh.closest(point);
        const std::optional<ClosestPoint> found = bvh.closest(point, nearby, at_centre->triangle, tested);
        REQUIRE(found);
        CHECK((found->triangle == truth.triangle && found->feature == truth.feature && found->point == truth.point && found->distance == truth.distance));
        (share * reach < 0.99 * nearby.reach ? from_nearby : walked) += 1;
      }
    }
  }
  CHECK(from_nearby > 1000);  // both code paths are exercised
  CHECK(walked > 1000);
}

TEST_CASE("bvh: among equal distances the lowest panel counts, wherever the search begins") {
  const Surface cube(fixtures::unit_cube());
  const Bvh bvh(cube);
  for (int guess = -1; guess < 12; ++guess) {
    std::size_t tested = 0;
    const std::optional<ClosestPoint> closest = bvh.closest({0.5, 0.5, 0.5}, Bvh::no_cap, guess, tested);  // half from each of the six
    REQUIRE(closest);
    CHECK(closest->triangle == 0);
    CHECK(cube.triangles()[0].panel == 0);
  }
}

TEST_CASE("bvh: among the triangles that face a viewer, the closest one is found") {
  const Surface surface(fixtures::torus(0.4, 0.15, 24, 12));
  const Bvh bvh(surface);
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3d point = fixtures::random_in_box(random, {-0.6, -0.6, -0.2}, {0.6, 0.6, 0.2});
    const Vec3d viewer = fixtures::random_in_box(random, {-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6});
    double truth = 1e300;
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      const std::array<Vec3d, 3> corners{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
      if (dot(viewer - corners[0], cross(corners[1] - corners[0], corners[2] - corners[0])) > 0)
        truth = std::min(truth, fixtures::Soup::distance(point, corners));
    }
    std::size_t tested = 0;
    const auto closest = bvh.closest_facing(point, viewer, Bvh::no_cap, tested);
    CHECK(closest.has_value() == (truth < 1e300));
    if (closest) CHECK(std::fabs(closest->distance - truth) < 1e-14);  // rounding of numbers below one
  }
}

TEST_CASE("bvh: the distance to a segment is the least to any triangle, and 0 if it crosses one") {
  for (const fixtures::Body& body : meshes()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    const fixtures::Soup soup(surface);
    const Box& bounds = surface.report().bounds;
    std::mt19937_64 random(9);
    for (int trial = 0; trial < 50; ++trial) {
      const Vec3d start = fixtures::random_in_box(random, bounds.low, bounds.high) + 0.1 * fixtures::random_direction(random);
      const Path path{start, start + (trial % 2 == 0 ? 0.05 : 0.5) * fixtures::random_direction(random)};
      std::size_t tested = 0;
      const auto distance = bvh.distance_to_segment(path.start, path.end, Bvh::no_cap, tested);
      REQUIRE(distance);
      const double truth = soup.distance(path);
      CHECK(*distance <= truth + 1e-12 * largest_magnitude(bounds.high));  // rounding of coordinates
      CHECK(*distance >= truth - 1e-9);                                    // the accuracy of the reference minimum
      CHECK_FALSE(bvh.distance_to_segment(path.start, path.end, *distance - 1e-9, tested));
    }
  }
}

TEST_CASE("bvh: with cached surroundings the distance to a segment is the same number") {
  std::size_t cached = 0, found = 0;
  for (const fixtures::Body& body : meshes()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    const Box& bounds = surface.report().bounds;
    std::mt19937_64 random(12);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3d start = fixtures::random_in_box(random, bounds.low, bounds.high) + 0.02 * fixtures::random_direction(random);
      std::size_t tested = 0;
      Bvh::Nearby nearby;
      const double way = 0.002, reach = 0.004;  // m; far below the size of a triangle
      const auto closest = bvh.closest(start, Bvh::no_cap, -1, reach, nearby, tested);
      REQUIRE(closest);
      for (const double cap : {closest->distance - way, closest->distance, closest->distance + way}) {
        const Vec3d end = start + way * fixtures::random_direction(random);
        const auto distance = bvh.distance_to_segment(start, end, cap, nearby, tested);
        CHECK(distance == bvh.distance_to_segment(start, end, cap, tested));
        cached += nearby.covers(cap + way);
        found += distance.has_value();
      }
    }
  }
  CHECK(cached > 1000);
  CHECK(found > 1000);
}

TEST_CASE("bvh: paths straight at vertices and edges never pass through") {
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> unit(0, 1);
    std::size_t missed = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
      const std::size_t t = random() % surface.triangles().size(), e = random() % 3;
      const double along = trial % 2 == 0 ? 0 : unit(random);
      const Vec3d place = surface.corner(t, e) + along * (surface.corner(t, (e + 1) % 3) - surface.corner(t, e));
      const Vec3d out = surface.pseudonormal(t, static_cast<Feature>((along == 0 ? 4 : 1) + e));
      const Vec3d way = normalised(out + 0.4 * fixtures::random_direction(random));
      const Vec3d start = place + 1e-3 * way, end = place - 1e-3 * way;
      // through the point, so one of the two directions meets a front
      std::size_t tested = 0;
      const bool hit = bvh.first_hit(start, end, tested).has_value() || bvh.first_hit(end, start, tested).has_value();
      missed += !hit;
    }
    CHECK(missed == 0);
  }
}

TEST_CASE("bvh: of all triangles, the first hit and the first contact are the first of any triangle alone, whatever the guess") {
  std::size_t hits = 0;
  for (const fixtures::Body& body : meshes()) {
    CAPTURE(body.name);
    const Surface surface(body.panels);
    const Bvh bvh(surface);
    std::vector<Bvh> alone;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) alone.emplace_back(surface, std::span(&t, 1));
    const Box& bounds = surface.report().bounds;
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 100; ++trial) {
      const Vec3d start = fixtures::random_in_box(random, bounds.low, bounds.high) + 0.02 * fixtures::random_direction(random);
      const Vec3d end = start + (trial % 2 == 0 ? 0.05 : 1.0) * fixtures::random_direction(random);
      for (const double radius : {0.0, 0.01, 0.2}) {
        std::size_t tested = 0;
        const auto ask = [&](const Bvh& tree, int guess) {
          return radius == 0 ? tree.first_hit(start, end, tested) : tree.first_contact(start, end, radius, 1e-12, guess, tested);
        };
        std::optional<Crossing> expected;
        double until = 1;
        for (const Bvh& one : alone)
          if (const auto crossing = ask(one, -1)) take_if_first(surface, *crossing, expected, until);
        for (const int guess : {-1, static_cast<int>(random() % surface.triangles().size())}) {
          const std::optional<Crossing> found = ask(bvh, guess);
          REQUIRE(found.has_value() == expected.has_value());
          if (!found) continue;
          CHECK(found->triangle == expected->triangle);
          CHECK(found->fraction == expected->fraction);
          ++hits;
        }
      }
    }
  }
  CHECK(hits > 1000);
}

TEST_CASE("bvh: the first hit is the nearest of all front faces on the path") {
  const Surface surface(fixtures::torus(0.4, 0.15, 24, 12));
  const Bvh bvh(surface);
  std::size_t tested = 0;
  const auto first = bvh.first_hit({-2, 0.01, 0.02}, {2, 0.01, 0.02}, tested);
  REQUIRE(first);
  // the outer equator of a torus of 24 × 12 panels is at most 0.55 and at least 0.55 cos(π/24) away from the axis
  CHECK(-2 + 4 * first->fraction == fixtures::relative(-0.547, 0.01));
}

TEST_CASE("bvh: queries with not-a-number, or beyond the range of floats, find nothing and terminate") {
  const Surface surface(fixtures::sphere());
  const Bvh bvh(surface);
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Vec3d& point : {Vec3d{nan, 0, 0}, Vec3d{0, nan, 0}, Vec3d{nan, nan, nan}, Vec3d{inf, 0, 0}, Vec3d{0, -inf, nan}, Vec3d{1e300, 0, 0}}) {
    std::size_t tested = 0;
    CHECK_FALSE(bvh.closest(point));
    CHECK_FALSE(bvh.closest_facing(point, {0, 0, 2}, 1, tested));
    if (is_finite(point)) continue;
    CHECK_FALSE(bvh.first_hit(point, {0, 0, 0}, tested));
    CHECK_FALSE(bvh.distance_to_segment({0, 0, 0}, point, 1, tested));
  }
}
