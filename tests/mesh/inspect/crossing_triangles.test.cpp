#include "mesh/inspect/crossing_triangles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

// Integer coordinates of a few units: the determinants of the reference are exact.
using Point = std::array<long, 3>;
using Corners = std::array<Point, 3>;

long orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<long, 3>, 3> m{};
  for (std::size_t k = 0; k < 3; ++k) m[0][k] = b[k] - a[k], m[1][k] = c[k] - a[k], m[2][k] = d[k] - a[k];
  const long determinant =
      m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (determinant > 0) - (determinant < 0);
}

/// Sufficient: an edge of one crosses the interior of the other.
bool goes_through(const Point& p, const Point& q, const Corners& t) {
  if (orientation(t[0], t[1], t[2], p) * orientation(t[0], t[1], t[2], q) >= 0) return false;
  const long a = orientation(p, q, t[0], t[1]), b = orientation(p, q, t[1], t[2]), c = orientation(p, q, t[2], t[0]);
  return a != 0 && a == b && b == c;
}
bool is_pierced(const Corners& one, const Corners& other) {
  for (std::size_t e = 0; e < 3; ++e)
    if (goes_through(one[e], one[(e + 1) % 3], other) || goes_through(other[e], other[(e + 1) % 3], one)) return true;
  return false;
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point times(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
long dot_of(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point normal_of(const Corners& t) { return times(minus(t[1], t[0]), minus(t[2], t[0])); }

struct Fraction {
  long top, bottom;  // bottom > 0
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.top * b.bottom < b.top * a.bottom; }
};

/// Necessary and sufficient, in fractions: the intervals on the common line overlap over a length.
bool cross_exactly(const Corners& one, const Corners& other) {
  const Point line = times(normal_of(one), normal_of(other));
  std::array<std::array<Fraction, 2>, 2> range{};
  for (std::size_t which = 0; which < 2; ++which) {
    const Corners &t = which == 0 ? one : other, &plane = which == 0 ? other : one;
    std::array<long, 3> height{};
    for (std::size_t c = 0; c < 3; ++c) height[c] = dot_of(minus(t[c], plane[0]), normal_of(plane));
    if (!(*std::min_element(height.begin(), height.end()) < 0 && *std::max_element(height.begin(), height.end()) > 0)) return false;
    std::vector<Fraction> at;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t next = (c + 1) % 3;
      if (height[c] == 0) at.push_back({dot_of(t[c], line), 1});
      if (height[c] * height[next] >= 0) continue;
      const long sum = std::abs(height[c]) + std::abs(height[next]);
      at.push_back({dot_of(t[c], line) * std::abs(height[next]) + dot_of(t[next], line) * std::abs(height[c]), sum});
    }
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    range[which] = {*low, *high};
  }
  return std::max(range[0][0], range[1][0]) < std::min(range[0][1], range[1][1]);
}

TriangleCorners in_doubles(const Corners& corners) {
  TriangleCorners out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = {double(corners[c][0]), double(corners[c][1]), double(corners[c][2])};
  return out;
}

}  // namespace

TEST_CASE("crossing: random triangles of small integers, in every degenerate contact, cross exactly as in exact arithmetic") {
  std::mt19937 random(11);
  std::uniform_int_distribution<long> coordinate(0, 4);
  int crossing = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    Corners one, other;
    for (Corners* corners : {&one, &other})
      for (Point& point : *corners)
        for (long& x : point) x = coordinate(random);
    if (normal_of(one) == Point{} || normal_of(other) == Point{}) continue;
    const bool expected = cross_exactly(one, other);
    REQUIRE((expected || !is_pierced(one, other)));
    REQUIRE(crossing_of(in_doubles(one), in_doubles(other)).has_value() == expected);
    crossing += expected ? 1 : 0;
  }
  CHECK(crossing > 20000);  // otherwise little was tested
}

TEST_CASE("crossing: the point lies on both triangles") {
  const TriangleCorners flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, upright{{{1, 1, -1}, {1, 1, 2}, {1, 9, 1}}};
  const auto at = crossing_of(flat, upright);
  REQUIRE(at);
  CHECK(at->x == fixtures::relative(1, 1e-12));
  CHECK(at->z == fixtures::absolute(0, 1e-12, "m"));
  CHECK(at->y > 1);
  CHECK(at->y < 3);
  CHECK(crossing_of(upright, flat).has_value());
}

TEST_CASE("crossing: triangles that share a corner or an edge, are coplanar, or just touch do not cross, at any position") {
  // far from the origin and rotated, so that rounding matters
  const auto placed = [](const TriangleCorners& t) {
    TriangleCorners out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = {1e6 + 0.6 * t[c].x - 0.8 * t[c].y, -3e5 + 0.8 * t[c].x + 0.6 * t[c].y, 0.1 + t[c].z};
    return out;
  };
  const TriangleCorners base = placed({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  const auto apart = [&](TriangleCorners other) { return !crossing_of(base, placed(other)).has_value(); };
  CHECK(apart({{{0, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}}}));          // an edge
  CHECK(apart({{{0, 0, 0}, {1, 1, 1}, {0.5, 0.4, 1}}}));          // a corner
  CHECK(apart({{{0.2, 0.2, 0}, {0.9, 0.8, 0}, {0.1, 0.7, 0}}}));  // coplanar
  CHECK(apart({{{0, 0, 1e-3}, {1, 0, 1e-3}, {0, 1, 1e-3}}}));     // parallel
}
