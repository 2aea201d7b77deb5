#include "mesh/remesh/fan_shift.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr Vec3d up{0, 0, 1};

/// Links about (0, 0, z) at random distances and heights. Open ones begin on +x and end on -x, at the height of the centre.
std::vector<Vec3d> random_link(std::mt19937_64& random, std::size_t count, bool goes_round) {
  std::uniform_real_distribution<double> distance(0.6, 1.4), height(-0.3, 0.3);
  std::vector<Vec3d> link;
  for (std::size_t j = 0; j < count; ++j) {
    const double angle =
        (goes_round ? 2 * std::numbers::pi / static_cast<double>(count) : std::numbers::pi / static_cast<double>(count - 1)) * static_cast<double>(j);
    const double r = distance(random);
    const bool is_end = !goes_round && (j == 0 || j + 1 == count);
    link.push_back({r * std::cos(angle), is_end ? 0 : r * std::sin(angle), is_end ? 0 : height(random)});
  }
  return link;
}

/// Height of the triangle over (x, y); nothing beside it.
std::optional<double> height(const std::array<Vec3d, 3>& t, double x, double y) {
  const auto area = [&](const Vec3d& a, const Vec3d& b) { return (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x); };
  const double a = area(t[1], t[2]), b = area(t[2], t[0]), c = area(t[0], t[1]);
  if (!(a >= 0 && b >= 0 && c >= 0) || a + b + c == 0) return std::nullopt;
  return (a * t[0].z + b * t[1].z + c * t[2].z) / (a + b + c);
}

/// By sampling the polygon: the largest difference of heights; nothing if one of the two covers a point twice or faces down.
std::optional<double> sampled_shift(const Fan& fan, std::size_t to) {
  std::vector<std::array<Vec3d, 3>> old_ones, new_ones;
  for (std::size_t j = 0; j < fan.size(); ++j) {
    const std::size_t next = (j + 1) % fan.link.size();
    old_ones.push_back({fan.centre, fan.link[j], fan.link[next]});
    if (j != to && next != to) new_ones.push_back({fan.link[to], fan.link[j], fan.link[next]});
  }
  for (const auto* triangles : {&old_ones, &new_ones})
    for (const auto& t : *triangles)
      if (cross(t[1] - t[0], t[2] - t[0]).z <= 0) return std::nullopt;
  double largest = 0;
  constexpr int steps = 150;
  for (int i = -steps; i <= steps; ++i)
    for (int k = -steps; k <= steps; ++k) {
      // slightly oblique, so that no point lies on an edge and counts twice
      const double x = 1.5 * i / steps + 1e-7, y = 1.5 * k / steps + 3e-7;
      std::optional<double> old_height, new_height;
      for (const auto& t : old_ones)
        if (const auto h = height(t, x, y)) old_height = h;
      for (const auto& t : new_ones)
        if (const auto h = height(t, x, y)) new_height = h;
      if (old_height && new_height) largest = fixtures::larger(largest, std::fabs(*old_height - *new_height));
    }
  return largest;
}

}  // namespace

TEST_CASE("fan shift: it is the largest difference of heights, by sampling the polygon") {
  std::mt19937_64 random(11);
  std::size_t taken = 0, refused = 0;
  for (int k = 0; k < 60; ++k) {
    const bool goes_round = k % 3 != 0;
    const std::vector<Vec3d> link = random_link(random, 4 + static_cast<std::size_t>(k) % 5, goes_round);
    const Fan fan{{0, 0, goes_round ? 0.2 : 0.0}, link, goes_round};
    const std::size_t to = goes_round ? static_cast<std::size_t>(k) % link.size() : (k % 2 == 0 ? 0 : link.size() - 1);
    const std::optional<double> found = shift(fan, to, up), expected = sampled_shift(fan, to);
    REQUIRE(found.has_value() == expected.has_value());
    found ? ++taken : ++refused;
    if (!found) continue;
    CHECK(*found >= *expected - 1e-12);  // rounding
    CHECK(*found <= *expected + 0.02);   // a hundredth between points, times a slope of two
  }
  CHECK(taken > 15);
  CHECK(refused > 5);
}

TEST_CASE("fan shift: the same in any frame") {
  std::mt19937_64 random(2);
  const std::vector<Vec3d> link = random_link(random, 6, true);
  for (std::size_t to = 0; to < link.size(); ++to) {
    const std::optional<double> expected = shift({{0, 0, 0.2}, link, true}, to, up);
    // x to y, y to z, z to x, and far from the origin
    const auto turned = [](const Vec3d& p) { return Vec3d{p.z, p.x, p.y}; };
    const Vec3d away{100, -200, 300};
    std::vector<Vec3d> other;
    for (const Vec3d& p : link) other.push_back(turned(p) + away);
    const std::optional<double> found = shift({turned({0, 0, 0.2}) + away, other, true}, to, turned(up));
    REQUIRE(found.has_value() == expected.has_value());
    if (found) CHECK(*found == fixtures::relative(*expected, 1e-11));  // coordinates of 300 m are rounded to 6e-14
  }
}

TEST_CASE("fan shift: a fan of two revolutions, or facing away from the direction, has none") {
  std::vector<Vec3d> twice;
  for (int j = 0; j < 12; ++j) twice.push_back({std::cos(std::numbers::pi * j / 3), std::sin(std::numbers::pi * j / 3), 0.01 * j});
  twice[0] = 0.05 * twice[0];  // so near to the centre that the new triangles from here all face up, and make two revolutions too
  CHECK(!shift({{0, 0, 0}, twice, true}, 0, up));
  const std::vector<Vec3d> square{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  CHECK(shift({{0, 0, 0.5}, square, true}, 0, up).value() == fixtures::relative(0.5, 1e-12));
  CHECK(!shift({{0, 0, 0.5}, square, true}, 0, -up));
  CHECK(!shift({{0, 0, 0.5}, square, true}, 0, Vec3d{1, 0, 0}));
}
