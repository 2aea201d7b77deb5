#include "mesh/add_polygon.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

/// Sum of the triangles' areas, signed by their winding seen from above: it equals the polygon's only if no triangle is flipped.
struct Areas {
  double with_sign = 0, without = 0;
};

Areas areas(const Panels& panels) {
  Areas out;
  const auto at = [&](int v) { return panels.vertices[static_cast<std::size_t>(v)]; };
  for (const auto& p : panels.panels) {
    const Vec3d doubled = cross(at(p[1]) - at(p[0]), at(p[2]) - at(p[0]));
    out.with_sign += 0.5 * doubled.z;
    out.without += 0.5 * std::abs(doubled.z);
  }
  return out;
}

double shoelace(const std::vector<Vec3d>& corners) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3d &a = corners[k], &b = corners[(k + 1) % corners.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return 0.5 * sum;
}

std::vector<int> all(const Panels& panels) {
  std::vector<int> corners(panels.vertices.size());
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

/// A star of random radii: any of its corners may be re-entrant, and its sides never cross.
std::vector<Vec3d> star(int corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.2, 1);
  std::vector<Vec3d> out;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners, r = radius(random);
    out.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return out;
}

/// Twice the area of three corners on whole numbers: exact.
double orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a).z; }

bool has_crossing_sides(const std::vector<Vec3d>& corners) {
  const auto at = [&](std::size_t k) { return corners[k % corners.size()]; };
  for (std::size_t a = 0; a < corners.size(); ++a) {
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (orientation(at(a), at(a + 1), at(c)) * orientation(at(a), at(a + 1), at(c + 1)) < 0 &&
          orientation(at(c), at(c + 1), at(a)) * orientation(at(c), at(c + 1), at(a + 1)) < 0)
        return true;
    }
  }
  return false;
}

/// A fan about its first corner, all seen from above, with the total angle `turn` [rad] on a widening spiral.
Panels staircase(double turn) {
  Panels panels{{{0, 0, 0}}, {}, {}, {}};
  constexpr int steps = 40;
  for (int k = 0; k <= steps; ++k) panels.vertices.push_back({(1 + 0.01 * k) * std::cos(turn * k / steps), (1 + 0.01 * k) * std::sin(turn * k / steps), 0});
  return panels;
}

}  // namespace

TEST_CASE("polygon: triangles and quads are unchanged, a convex polygon becomes a fan") {
  Panels panels{{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}}, {}, {}, {}};
  REQUIRE(add_polygon(panels, std::vector{0, 1, 2}));
  REQUIRE(add_polygon(panels, std::vector{0, 1, 2, 3}));
  REQUIRE(add_polygon(panels, std::vector{0, 1, 2, 3, 4}));
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {0, 1, 2, 3}, {0, 1, 2, -1}, {0, 2, 3, -1}, {0, 3, 4, -1}});
}

TEST_CASE("polygon: random concave ones of up to a hundred corners are covered once, by the shoelace formula") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    Panels panels{star(5 + trial % 96, random), {}, {}, {}};
    REQUIRE(add_polygon(panels, all(panels)));
    CHECK(panels.panels.size() == panels.vertices.size() - 2);
    const double area = shoelace(panels.vertices);
    constexpr double rounding = 1e-12;  // of a hundred terms about 1
    CHECK(std::abs(areas(panels).with_sign - area) < rounding);
    CHECK(std::abs(areas(panels).without - area) < rounding);
  }
}

TEST_CASE("polygon: a comb, with every second corner deeply re-entrant, is covered once") {
  Panels comb;
  for (int k = 0; k <= 40; ++k) comb.vertices.push_back({double(k), k % 2 == 0 ? 10.0 : 0.5, 0});
  comb.vertices.push_back({40, 0, 0});
  comb.vertices.insert(comb.vertices.begin(), {0, 0, 0});
  std::vector<int> corners = all(comb);
  std::reverse(corners.begin(), corners.end());  // counterclockwise from above
  REQUIRE(add_polygon(comb, corners));
  std::vector<Vec3d> outline(comb.vertices.rbegin(), comb.vertices.rend());
  CHECK(areas(comb).without == fixtures::relative(shoelace(outline), 1e-12));
  CHECK(areas(comb).with_sign == fixtures::relative(shoelace(outline), 1e-12));
}

TEST_CASE("polygon: collinear corners are covered exactly once") {
  std::mt19937 random(11);
  for (int trial = 0; trial < 500; ++trial) {
    // one corner per direction from the origin, on integers: many are straight, or collinear with two others
    std::vector<Vec3d> points;
    for (int k = 0; k < 30; ++k) points.push_back({double(random() % 9) - 4, double(random() % 9) - 4, 0});
    std::sort(points.begin(), points.end(), [](const Vec3d& a, const Vec3d& b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    Panels panels;
    for (const Vec3d& point : points) {
      const bool is_new = panels.vertices.empty() || cross(panels.vertices.back(), point).z > 0;
      if (point != Vec3d{} && is_new) panels.vertices.push_back(point);
    }
    const std::vector<Vec3d>& outline = panels.vertices;
    if (outline.size() < 5 || cross(outline.back(), outline.front()).z <= 0) continue;
    REQUIRE(add_polygon(panels, all(panels)));
    CHECK(panels.panels.size() == outline.size() - 2);
    CHECK(areas(panels).with_sign == shoelace(outline));  // halves, exact
    CHECK(areas(panels).without == shoelace(outline));
  }
}

TEST_CASE("polygon: random ones with crossing sides are rejected, whatever their corners") {
  std::mt19937 random(5);
  int crossing = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Panels panels;
    for (int k = 0; k < 5 + trial % 5; ++k) panels.vertices.push_back({double(random() % 12), double(random() % 12), 0});
    if (!has_crossing_sides(panels.vertices)) continue;
    ++crossing;
    CHECK_FALSE(add_polygon(panels, all(panels)));
  }
  CHECK(crossing > 1000);
}

TEST_CASE("polygon: a fan may make one revolution about its first corner, but no more") {
  constexpr double pi = std::numbers::pi;
  for (const double turn : {1.9 * pi, 2 * pi}) {
    Panels once = staircase(turn);
    REQUIRE(add_polygon(once, all(once)));
    CHECK(once.panels.size() == 40);
    CHECK(areas(once).without == fixtures::relative(shoelace(once.vertices), 1e-12));
  }
  for (const double turn : {2.1 * pi, 3 * pi, 4.5 * pi}) {
    Panels twice = staircase(turn);
    CHECK_FALSE(add_polygon(twice, all(twice)));
    CHECK(twice.panels.empty());
  }
  // two lobes that meet in the first corner: side by side they are a fan, overlapping they are not
  Panels beside{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 0, 0}, {2, 4, 0}, {0, 4, 0}}, {}, {}, {}};
  CHECK(add_polygon(beside, all(beside)));
  Panels over{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {3, 3, 0}, {1, 2, 0}}, {}, {}, {}};
  CHECK_FALSE(add_polygon(over, all(over)));
}

TEST_CASE("polygon: one with crossing sides, of too few corners, or of too many without a fan is rejected and adds nothing") {
  Panels crossed{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 5, 0}}, {}, {}, {}};
  CHECK_FALSE(add_polygon(crossed, all(crossed)));
  Panels figure_eight{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.5, 0}}, {}, {}, {}};
  CHECK_FALSE(add_polygon(figure_eight, all(figure_eight)));
  CHECK_FALSE(add_polygon(crossed, std::vector{0, 1}));
  std::mt19937 random(3);
  Panels large{star(501, random), {}, {}, {}};
  CHECK_FALSE(add_polygon(large, all(large)));
  CHECK(crossed.panels.empty());
  CHECK(figure_eight.panels.empty());
  CHECK(large.panels.empty());
}

TEST_CASE("polygon: a convex one may have any number of corners") {
  Panels circle;
  for (int k = 0; k < 100000; ++k) circle.vertices.push_back({std::cos(2e-5 * std::numbers::pi * k), std::sin(2e-5 * std::numbers::pi * k), 0});
  REQUIRE(add_polygon(circle, all(circle)));
  CHECK(areas(circle).without == fixtures::relative(0.5e5 * std::sin(2e-5 * std::numbers::pi), 1e-12));  // rounding of 1e5 terms of one sign
}
