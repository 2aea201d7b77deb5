#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/prism.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"

using namespace fccda;
using std::numbers::pi;
using std::numbers::sqrt2;

namespace {

double longest_side(const Panels& panels) {
  double longest = 0;
  for (const auto& p : panels.panels) {
    const std::size_t corners = p[3] < 0 ? 3 : 4;
    for (std::size_t c = 0; c < corners; ++c) {
      const auto from = static_cast<std::size_t>(p[c]), to = static_cast<std::size_t>(p[(c + 1) % corners]);
      longest = fixtures::larger(longest, norm(panels.vertices[from] - panels.vertices[to]));
    }
  }
  return longest;
}

double volume(const Panels& panels) {
  double sum = 0;
  fixtures::for_each_triangle(panels, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { sum += dot(a, cross(b, c)) / 6; });
  return sum;
}

bool is_mirror_image(const Panels& panels, std::size_t axis) {
  const auto key = [](const Vec3d& v) { return std::array{v.x + 0.0, v.y + 0.0, v.z + 0.0}; };  // -0 is 0
  std::set<std::array<double, 3>> places;
  for (const Vec3d& v : panels.vertices) places.insert(key(v));
  return std::all_of(panels.vertices.begin(), panels.vertices.end(), [&](Vec3d v) {
    v[axis] = -v[axis];
    return places.contains(key(v));
  });
}

const double panel_sizes[] = {0.06, 0.02, 0.0113, 0.005, 0.002};

}  // namespace

TEST_CASE("shapes: each is watertight, oriented outward and of genus 0, for coarse and fine panels") {
  for (const double panel : panel_sizes) {
    for (const PanelKind kind : {PanelKind::triangles, PanelKind::quads}) {
      for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const Panels cylinder = make_cylinder({.diameter = 0.05, .height = 0.025, .axis = axis, .edge_length = panel, .panels = kind});
        CHECK(fixtures::is_watertight(cylinder));
        CHECK(fixtures::euler_characteristic(cylinder) == 2);
        CHECK(volume(cylinder) > 0);
      }
      const Panels box = make_box({.size = {0.03, 0.05, 0.021}, .edge_length = panel, .panels = kind});
      CHECK(fixtures::is_watertight(box));
      CHECK(fixtures::euler_characteristic(box) == 2);
      CHECK(volume(box) == fixtures::relative(0.03 * 0.05 * 0.021, 1e-12));  // rounding of some thousand terms
    }
    const Panels sphere = make_sphere({.diameter = 0.05, .edge_length = panel});
    CHECK(fixtures::is_watertight(sphere));
    CHECK(fixtures::euler_characteristic(sphere) == 2);
    CHECK(volume(sphere) > 0);
  }
}

TEST_CASE("shapes: no edge is longer than the edge length, no diagonal longer than √2 times it") {
  constexpr double rounding = 1 + 1e-8;  // ten times the tolerance of divisions() for a whole number of panels
  std::vector<double> sizes(std::begin(panel_sizes), std::end(panel_sizes));
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) sizes.push_back(std::uniform_real_distribution<double>(0.002, 0.06)(random));
  for (const double panel : sizes) {
    CHECK(longest_side(make_sphere({.diameter = 0.05, .edge_length = panel})) <= panel * rounding);
    CHECK(longest_side(make_box({.size = {0.03, 0.05, 0.021}, .edge_length = panel, .panels = PanelKind::quads})) <= panel * rounding);
    CHECK(longest_side(make_box({.size = {0.03, 0.05, 0.021}, .edge_length = panel})) <= sqrt2 * panel * rounding);
    CHECK(longest_side(make_cylinder({.diameter = 0.05, .height = 0.025, .edge_length = panel})) <= sqrt2 * panel * rounding);
    Panels lateral = make_cylinder({.diameter = 0.05, .height = 0.025, .edge_length = panel, .panels = PanelKind::quads});
    std::erase_if(lateral.panels, [](const auto& p) { return p[3] < 0; });
    CHECK(longest_side(lateral) <= panel * rounding);
  }
}

TEST_CASE("shapes: a whole number of panels is taken as such") {
  CHECK(divisions(0.025, 0.0001) == 250);
  CHECK(divisions(0.05, 0.001) == 50);
  CHECK(divisions(3 * 0.1, 0.1) == 3);  // 3.0000000000000004 as doubles
  CHECK(divisions(0.0501, 0.001) == 51);
  CHECK(divisions(0.1, 0.5) == 1);
  CHECK(circle_divisions(1, sqrt2) == 4);          // the square in the circle
  CHECK(circle_divisions(0.025, 0.0001) == 1572);  // π/asin(0.002) = 1570.8
  CHECK(circle_divisions(0.025, 0.002) == 80);     // 78.5
  CHECK(circle_divisions(1, 10) == 4);
}

TEST_CASE("shapes: the cylinder's columns lie on the coordinate planes and are exact mirror images") {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    for (const double panel : panel_sizes) {
      const Panels cylinder = make_cylinder({.diameter = 0.05, .height = 0.025, .axis = axis, .edge_length = panel});
      const auto along = static_cast<std::size_t>(axis), u = (along + 1) % 3, v = (along + 2) % 3;
      for (std::size_t mirror = 0; mirror < 3; ++mirror) CHECK(is_mirror_image(cylinder, mirror));
      CHECK(cylinder.vertices[0][u] == 0.025);  // column 0
      CHECK(cylinder.vertices[0][v] == 0);
      const auto opposite = std::count_if(cylinder.vertices.begin(), cylinder.vertices.end(), [&](const Vec3d& p) { return p[v] == -0.025 && p[u] == 0; });
      CHECK(double(opposite) == divisions(0.025, panel) + 1);
      for (const Vec3d& p : cylinder.vertices) {
        const double r = std::hypot(p[u], p[v]);
        CHECK(r <= 0.025 * (1 + 1e-15));  // two roundings
        if (std::fabs(p[along]) < 0.0124) CHECK(r == fixtures::relative(0.025, 1e-15));
      }
    }
  }
}

TEST_CASE("shapes: sphere and box are mirror images too, and the sphere's vertices lie on the sphere") {
  for (const double panel : panel_sizes) {
    const Panels sphere = make_sphere({.diameter = 0.05, .edge_length = panel});
    for (const Vec3d& p : sphere.vertices) CHECK(norm(p) == fixtures::relative(0.025, 1e-15));
    const Panels box = make_box({.size = {0.03, 0.05, 0.021}, .edge_length = panel});
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(is_mirror_image(box, axis));
  }
}

TEST_CASE("shapes: the cylinder has exactly the volume of its prism, whatever the panels") {
  for (const double panel : panel_sizes) {
    for (const PanelKind kind : {PanelKind::triangles, PanelKind::quads}) {
      const double n = circle_divisions(0.025, panel);
      const double prism = 0.5 * n * 0.025 * 0.025 * std::sin(2 * pi / n) * 0.025;
      CHECK(volume(make_cylinder({.diameter = 0.05, .height = 0.025, .edge_length = panel, .panels = kind})) == fixtures::relative(prism, 1e-12));  // rounding
    }
  }
}

TEST_CASE("shapes: far too small panels are rejected before memory is allocated") {
  CHECK_THROWS_WITH_AS(make_sphere({.diameter = 1, .edge_length = 1e-9}),
                       "sphere: an edge length of 1e-09 m would give 8.75388e+18 panels, more than the limit of 1e+08; use a larger one.", InputError);
  CHECK_THROWS_AS(make_cylinder({.diameter = 1, .height = 1, .edge_length = 1e-9}), InputError);
  CHECK_THROWS_AS(make_cylinder({.diameter = 1e-9, .height = 1, .edge_length = 1e-9}), InputError);
  CHECK_THROWS_AS(make_box({.size = {1, 1e-9, 1e-9}, .edge_length = 1e-12}), InputError);
}

TEST_CASE("shapes: without an edge length a box has two triangles or a quad per side, a sphere and a cylinder edges of a twentieth of the diameter") {
  CHECK(make_box({.size = {1, 2, 3}}).panels.size() == 12);
  CHECK(make_box({.size = {1, 2, 3}, .panels = PanelKind::quads}).panels.size() == 6);
  const Surface box(make_box({.size = {1, 2, 3}}));
  CHECK(box.is_closed());
  CHECK(box.report().volume == fixtures::relative(6, 1e-14));  // roundings
  const auto same = [](const Panels& a, const Panels& b) { return a.vertices == b.vertices && a.panels == b.panels; };
  CHECK(same(make_sphere({.diameter = 2}), make_sphere({.diameter = 2, .edge_length = 0.1})));
  CHECK(same(make_cylinder({.diameter = 2, .height = 1}), make_cylinder({.diameter = 2, .height = 1, .edge_length = 0.1})));
}

TEST_CASE("shapes: lengths that are not positive and finite are rejected") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(make_box({.size = {1, bad, 1}, .edge_length = 0.5}), InputError);
    CHECK_THROWS_AS(make_sphere({.diameter = bad, .edge_length = 0.5}), InputError);
    CHECK_THROWS_AS(make_cylinder({.diameter = 1, .height = bad, .edge_length = 0.5}), InputError);
  }
  CHECK_THROWS_WITH_AS(make_box({.size = {1, 1, 1}, .edge_length = -0.5}), "box: the edge length is -0.5 m, but it must be positive; omit it for the default.",
                       InputError);
}

TEST_CASE("prism: the surface over a concave outline is closed, encloses its area times its height, and is the same for both orientations") {
  PrismShape ell{.outline = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, .height = 0.5};
  for (int way = 0; way < 2; ++way) {
    const Surface surface(make_prism(ell));
    CHECK(surface.is_closed());
    CHECK(surface.report().volume == fixtures::relative(4 * 0.5, 1e-14));         // roundings
    CHECK(surface.report().area == fixtures::relative(2 * 4 + 10 * 0.5, 1e-14));  // two ends, and the walls
    std::ranges::reverse(ell.outline);
  }
  for (const auto& outline : {std::vector<std::array<double, 2>>{{0, 0}, {0.5, -0.1}, {0, 1}, {-0.5, -0.1}}, {{0.5, -0.1}, {0, 1}, {-0.5, -0.1}, {0, 0}}}) {
    const Surface arrow(make_prism({.outline = outline}));           // a diagonal lies outside
    CHECK(arrow.report().volume == fixtures::relative(0.5, 1e-14));  // a triangle of 0.55 less one of 0.05
    CHECK(arrow.report().area == fixtures::relative(2 * 0.5 + 2 * std::hypot(0.5, 1.1) + 2 * std::hypot(0.5, 0.1), 1e-14));
  }
  CHECK_THROWS_AS(make_prism({.outline = {{0, 0}, {1, 0}}}), InputError);
  CHECK_THROWS_AS(make_prism({.outline = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), InputError);
  CHECK_THROWS_AS(make_prism({.outline = {{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}}), InputError);
  CHECK_THROWS_AS(make_prism({.outline = {{0, 0}, {1, 0}, {0, 1}}, .height = 0}), InputError);
}
