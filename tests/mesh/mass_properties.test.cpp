#include "mesh/mass_properties.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "base/quaternion.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"

using namespace fccda;
using std::numbers::pi;

namespace {
SurfaceReport report(const Panels& panels) { return Surface(panels).report(); }
constexpr double rounding = 1e-12;  // of sums of some thousand terms
}  // namespace

TEST_CASE("mass properties: a tetrahedron agrees with the textbook") {
  const SurfaceReport r = report(fixtures::tetrahedron());
  CHECK(r.volume == fixtures::relative(1 / 6.0, rounding));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(r.centroid[i] == fixtures::relative(0.25, rounding));
    CHECK(r.inertia_diagonal[i] == fixtures::relative(1 / 80.0, rounding));    // 2 (1/60 - 1/96)
    CHECK(r.inertia_products[i] == fixtures::relative(-1 / 480.0, rounding));  // 1/120 - 1/96
  }
}

TEST_CASE("mass properties: those of a rotated and translated brick are those of the brick, rotated") {
  const Vec3d size{1, 2, 3};
  const Mat3 turn = Quaternion::from_rotation({0.3, -1.1, 0.7}).matrix();
  const Vec3d shift{100, -50, 20};
  const SurfaceReport r = report(fixtures::moved(make_box({.size = size, .edge_length = 0.4}), [&](const Vec3d& v) { return turn * v + shift; }));
  constexpr double far = 1e-11;  // a hundred lengths from the origin cost two digits
  CHECK(r.volume == fixtures::relative(6, far));
  CHECK(norm(r.centroid - shift) < 100 * far);
  // ∫x xᵀ dV of the brick is diagonal with V s²/12
  const Mat3 moments = turn * Mat3::diagonal({6 / 12.0, 6 * 4 / 12.0, 6 * 9 / 12.0}) * transpose(turn);
  const double trace = 6 * (1 + 4 + 9) / 12.0;
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(r.inertia_diagonal[i] == fixtures::relative(trace - moments.row[i][i], far));
    CHECK(r.inertia_products[i] == fixtures::relative(moments.row[(i + 1) % 3][(i + 2) % 3], far));
  }
}

TEST_CASE("mass properties: a cylinder of n sides has exactly those of the prism") {
  for (const PanelKind kind : {PanelKind::triangles, PanelKind::quads}) {
    const double R = 0.025, h = 0.03, n = circle_divisions(R, 0.004), a = 2 * pi / n;
    const SurfaceReport r = report(make_cylinder({.diameter = 2 * R, .height = h, .edge_length = 0.004, .panels = kind}));
    const double area = 0.5 * n * R * R * std::sin(a);
    const double polar = area * R * R * (2 + std::cos(a)) / 6;  // of a regular polygon about its middle
    CHECK(r.volume == fixtures::relative(area * h, rounding));
    CHECK(r.inertia_diagonal.z == fixtures::relative(polar * h, rounding));
    CHECK(r.inertia_diagonal.x == fixtures::relative(0.5 * polar * h + area * h * h * h / 12, rounding));
    CHECK(r.inertia_diagonal.y == fixtures::relative(r.inertia_diagonal.x, rounding));
    CHECK(r.area == fixtures::relative(2 * area + n * 2 * R * std::sin(a / 2) * h, rounding));
    CHECK(norm(r.centroid) < rounding * R);
    CHECK(norm(r.inertia_products) < rounding * polar * h);
  }
}

TEST_CASE("mass properties: sphere and torus converge to the smooth ones with the square of the panel size") {
  const auto error_of_sphere = [](double panel) {
    const SurfaceReport r = report(make_sphere({.diameter = 2, .edge_length = panel}));
    return std::array{1 - r.volume / (4 * pi / 3), 1 - r.area / (4 * pi), 1 - r.inertia_diagonal.y / (8 * pi / 15)};
  };
  const auto error_of_torus = [](int around) {
    const SurfaceReport r = report(fixtures::torus(2, 0.5, 2 * around, around));
    const double volume = 2 * pi * pi * 2 * 0.25;
    return std::array{1 - r.volume / volume, 1 - r.area / (4 * pi * pi * 2 * 0.5), 1 - r.inertia_diagonal.z / (volume * (4 + 0.75 * 0.25))};
  };
  const auto sphere_coarse = error_of_sphere(0.14), sphere_fine = error_of_sphere(0.07);  // edges in 10 and 19 parts
  const auto torus_coarse = error_of_torus(40), torus_fine = error_of_torus(80);
  for (std::size_t k = 0; k < 3; ++k) {
    // the next term of the expansion is (panel/R)² of the first: some percent
    CHECK(sphere_coarse[k] / sphere_fine[k] == fixtures::relative(1.9 * 1.9, 0.05));
    CHECK(torus_coarse[k] / torus_fine[k] == fixtures::relative(4, 0.05));
    CHECK(sphere_fine[k] < 5 * 0.07 * 0.07 / 8);  // the sagitta panel²/8R; the inertia has five times its relative error
  }
}
