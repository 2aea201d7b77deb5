#include "mesh/shapes/halve_edges.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/vec3.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

struct FlatSheet {
  std::vector<Vec3d> points;
  std::vector<std::array<int, 3>> triangles;

  double length(int a, int b) const { return norm(points[static_cast<std::size_t>(a)] - points[static_cast<std::size_t>(b)]); }
  Vec3d middle(int a, int b) const { return 0.5 * (points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]); }

  template <class Size>
  void halve(const Size& size) {
    halve_edges(triangles, {.excess = [&](int a, int b) { return length(a, b) / size(middle(a, b)); },
                            .length = [&](int a, int b) { return length(a, b); },
                            .middle =
                                [&](int a, int b) {
                                  points.push_back(middle(a, b));
                                  return static_cast<int>(points.size()) - 1;
                                }});
  }

  double smallest_angle() const {
    double smallest = 10;
    for (const auto& t : triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3d at = points[static_cast<std::size_t>(t[c])];
        const Vec3d u = points[static_cast<std::size_t>(t[(c + 1) % 3])] - at, v = points[static_cast<std::size_t>(t[(c + 2) % 3])] - at;
        smallest = std::fmin(smallest, std::atan2(norm(cross(u, v)), dot(u, v)));
      }
    }
    return smallest;
  }
};

FlatSheet grid(int n, std::mt19937_64& random) {
  FlatSheet sheet;
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) sheet.points.push_back({(i + (i % n ? off(random) : 0)) / n, (j + (j % n ? off(random) : 0)) / n, 0});
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      sheet.triangles.push_back({a, b, b + 1});
      sheet.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return sheet;
}

}  // namespace

TEST_CASE("halved edges: none is longer than requested, the area is unchanged, the sheet stays conforming and angles do not fall below half of the smallest") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    FlatSheet sheet = grid(2 + static_cast<int>(random() % 4), random);
    const double angle = sheet.smallest_angle();
    const auto size = [&](const Vec3d& p) { return 0.02 + 0.4 * std::hypot(p.x - 0.1 * trial, p.y - 0.3); };
    sheet.halve(size);
    std::map<std::pair<int, int>, int> walked;
    double area = 0;
    for (const auto& t : sheet.triangles) {
      for (std::size_t e = 0; e < 3; ++e) {
        const int a = t[e], b = t[(e + 1) % 3];
        CHECK(sheet.length(a, b) <= size(sheet.middle(a, b)));
        walked[{a, b}] += 1;
      }
      const auto at = [&](std::size_t c) { return sheet.points[static_cast<std::size_t>(t[c])]; };
      const double twice = cross(at(1) - at(0), at(2) - at(0)).z;
      CHECK(twice > 0);  // orientation unchanged
      area += 0.5 * twice;
    }
    CHECK(area == fixtures::relative(1, 1e-12));  // sums of some thousand triangles
    for (const auto& one : walked) {
      CHECK(one.second == 1);
      const auto [a, b] = one.first;
      const Vec3d p = sheet.points[static_cast<std::size_t>(a)], q = sheet.points[static_cast<std::size_t>(b)];
      const bool is_boundary_edge = (p.x == q.x && (p.x == 0 || p.x == 1)) || (p.y == q.y && (p.y == 0 || p.y == 1));
      if (!is_boundary_edge) CHECK(walked.count({b, a}) == 1);  // a hanging vertex would leave a slit
    }
    CHECK(sheet.smallest_angle() >= 0.5 * angle * (1 - 1e-9));  // Rosenberg and Stenger (1975): halving the longest edge
  }
}

TEST_CASE("halved edges: a sheet that is fine enough is unchanged") {
  std::mt19937_64 random(1);
  FlatSheet sheet = grid(3, random);
  const auto before = sheet.triangles;
  sheet.halve([](const Vec3d&) { return 2.0; });
  CHECK(sheet.triangles == before);
}
