#include <doctest/doctest.h>

#include <random>
#include <string>

#include "fccda/core/error.hpp"
#include "fccda/region/all_regions.hpp"
#include "fixtures/surfaces.hpp"

using namespace fccda;

namespace {

std::vector<Region> every_region(const Surface& cube) {
  return {Unbounded{}, BoxRegion({.size = {1.2, 1, 1.4}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::error),
          BoxRegion({.size = {1, 0.4, 1}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::clip)};
}

}  // namespace

TEST_CASE("region: a path that comes within the margin of a panel inside is never called untouchable") {
  const Surface cube(fixtures::unit_cube());
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> reach(0, 0.2);
  for (const Region& region : every_region(cube)) {
    std::visit(
        [&](const auto& its) {
          for (int trial = 0; trial < 20'000; ++trial) {
            // A place on the cube, a point of the path within the margin of it, and a path through that point.
            Vec3d place = fixtures::random_in_box(random, {0, 0, 0}, {1, 1, 1});
            place[random() % 3] = static_cast<double>(random() % 2);
            if (!its.contains(place)) continue;
            const double margin = reach(random);
            const Vec3d near = place + margin * (1 - 1e-12) * fixtures::random_direction(random);
            const Vec3d way = reach(random) * fixtures::random_direction(random);
            CHECK(its.may_touch({near - way, near + 0.3 * way}, margin));
            // The margin again: its.distance_at_least may not exceed the distance from a place inside; 1e-15 for the rounding of
            // numbers of order one.
            CHECK(its.distance_at_least(near) <= norm(near - place) + 1e-15);
          }
        },
        region);
  }
}

TEST_CASE("region: far paths are rejected, and the distance is that from the box") {
  const Surface cube(fixtures::unit_cube());
  const BoxRegion box({.size = {1, 1, 1}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::error);
  CHECK_FALSE(box.may_touch({{1.2, 0, 0}, {1.11, 0, 0}}, 0.1));
  CHECK(box.may_touch({{1.2, 0, 0}, {1.09, 0, 0}}, 0.1));
  CHECK(box.distance_at_least({4, 5, 0.5}) == doctest::Approx(5).epsilon(1e-11));  // 3-4-5, the box widened by 1e-12
  CHECK(box.distance_at_least({0.5, 0.5, 0.5}) == 0);
}

TEST_CASE("region: a surface that fits exactly is not clipped, one that sticks out is an error naming the panels, unless it is meant") {
  const Surface cube(fixtures::unit_cube());
  CHECK_FALSE(BoxRegion({.size = {1, 1, 1}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::clip).clips());
  const BoxRegion::Shape thin{.size = {1, 1, 0.9}, .centre = {0.5, 0.5, 0.5}};
  CHECK(BoxRegion(thin, cube, Beyond::clip).clips());
  try {
    BoxRegion(thin, cube, Beyond::error);
    FAIL("no error");
  } catch (const InputError& error) {
    const std::string text = error.what();
    CHECK(text.find("6 of 6 panels stick out of the box by up to 0.05 m (panels 0, 1, 2, 3, 4, ...)") != std::string::npos);
    CHECK(text.find("clip") != std::string::npos);
  }
}

TEST_CASE("region: a box that holds none of the surface is an error even where clipping is meant") {
  const Surface cube(fixtures::unit_cube());
  CHECK_THROWS_AS(BoxRegion({.size = {1, 1, 1}, .centre = {5, 0, 0}}, cube, Beyond::clip), InputError);
}
