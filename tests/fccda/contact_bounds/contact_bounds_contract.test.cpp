// The guarantees of all contact bounds, for each kind.
#include <doctest/doctest.h>

#include "fccda/contact_bounds/scenes.hpp"
#include "fccda/detect/scene.hpp"

using namespace fccda;

TEST_CASE("contact bounds: a path within the margin of a panel inside is never rejected, and no distance is overestimated") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    const double size = norm(body.surface.report().bounds.size());
    for (const fixtures::NamedRegion& region : fixtures::every_region(body.surface)) {
      CAPTURE(body.name);
      CAPTURE(region.name);
      std::visit(
          [&](const auto& its) {
            std::size_t inside = 0;
            for (int trial = 0; trial < 2000; ++trial) {
              // A point of the surface, a point of the path within the margin of it, and a path through that point.
              const Vec3d place = fixtures::random_place(random, body.surface);
              if (!its.contains(place)) continue;
              ++inside;
              const double margin = 0.2 * size * unit(random);
              const Vec3d near = place + margin * (1 - 1e-12) * fixtures::random_direction(random);
              const Vec3d way = 0.2 * size * unit(random) * fixtures::random_direction(random);
              CHECK(its.may_contact({near - way, near + 0.3 * way}, margin));
              // 1e-14 of the size for the rounding of coordinates
              CHECK(its.distance_at_least(near) <= norm(near - place) + 1e-14 * size);
            }
            CHECK((its.clips() ? inside > 0 && inside < 2000 : inside == 2000));
          },
          region.region);
    }
  }
}

TEST_CASE("contact bounds: a rejected path is nowhere within the margin, by dense sampling of the path against every triangle") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    const double size = norm(body.surface.report().bounds.size());
    const fixtures::Soup soup(body.surface);
    std::vector<fixtures::NamedRegion> regions = fixtures::every_region(body.surface);
    std::erase_if(regions, [](const auto& region) { return std::visit([](const auto& its) { return its.clips(); }, region.region); });
    std::size_t rejected = 0;
    for (int trial = 0; trial < 150; ++trial) {
      const Vec3d start = fixtures::random_place(random, body.surface) + 0.2 * size * unit(random) * fixtures::random_direction(random);
      const Path path{start, start + 0.1 * size * unit(random) * fixtures::random_direction(random)};
      const double margin = 0.05 * size * unit(random);
      double nearest = 1e300, from_end = soup.distance(path.end);
      bool is_known = false;
      for (const fixtures::NamedRegion& region : regions) {
        CAPTURE(body.name);
        CAPTURE(region.name);
        std::visit(
            [&](const auto& its) {
              CHECK(its.distance_at_least(path.end) <= from_end + 1e-14 * size);
              if (its.may_contact(path, margin)) return;
              ++rejected;
              for (int k = 0; !is_known && k <= 8; ++k) nearest = std::min(nearest, soup.distance(path.at(k / 8.0)));
              is_known = true;
              CHECK(nearest > margin);
            },
            region.region);
      }
    }
    CHECK(rejected > 50);
  }
}

TEST_CASE("contact bounds: paths that are not numbers are not rejected") {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const Surface surface(fixtures::propeller({.edge_length = 0.06}));
  for (const fixtures::NamedRegion& region : fixtures::every_region(surface)) {
    CAPTURE(region.name);
    CHECK(std::visit([&](const auto& its) { return its.may_contact({{0, 0, 9}, {nothing, nothing, nothing}}, 0.1); }, region.region));
  }
}

TEST_CASE("contact bounds: fitted bounds contain the volume inside a closed surface too") {
  std::mt19937_64 random(5);
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    const Box& bounds = body.surface.report().bounds;
    const std::vector<fixtures::NamedRegion> regions = fixtures::every_region(body.surface);
    for (int trial = 0; trial < 300; ++trial) {
      const Vec3d point = fixtures::random_in_box(random, bounds.low, bounds.high);
      if (fixtures::winding_number(body.surface.panels(), point) < 0.5) continue;
      for (const fixtures::NamedRegion& region : regions) {
        CAPTURE(body.name);
        CAPTURE(region.name);
        if (region.name.starts_with("fitted") || region.name == "auto") CHECK(std::visit([&](const auto& its) { return its.contains(point); }, region.region));
      }
    }
  }
}
