#include "mesh/weld.hpp"

#include <doctest/doctest.h>

#include <random>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

std::size_t merged(const Vec3d& a, const Vec3d& b, double tolerance) { return weld({{a, b}, {{0, 1, 0, -1}}}, tolerance).merged; }

/// Each vertex with its own panel, so that all are used.
Panels cloud(const std::vector<Vec3d>& points) {
  Panels out{points, {}};
  for (int v = 0; v < int(points.size()); ++v) out.add_triangle(v, v, v);
  return out;
}

struct ByHand {
  std::vector<Vec3d> kept;
  std::vector<int> number;  // of the kept vertex that each was merged into
};

/// The definition in the header, by comparing all with all.
ByHand by_hand(const std::vector<Vec3d>& points, double tolerance) {
  ByHand out;
  for (const Vec3d& p : points) {
    int nearest = -1;
    double least = tolerance * tolerance;
    for (int k = 0; k < int(out.kept.size()); ++k) {
      const double squared_distance = squared_norm(out.kept[std::size_t(k)] - p);
      if (squared_distance >= least && squared_distance > 0) continue;
      nearest = k;
      least = squared_distance;
    }
    if (nearest < 0) {
      nearest = int(out.kept.size());
      out.kept.push_back(p);
    }
    out.number.push_back(nearest);
  }
  return out;
}

}  // namespace

TEST_CASE("weld: two vertices are merged exactly if nearer than the tolerance, on either side of the cells' boundaries") {
  std::mt19937_64 random(1);
  constexpr double tolerance = 1e-3;
  for (int trial = 0; trial < 20'000; ++trial) {
    // about the corners of cells of eight tolerances, where up to eight meet, and anywhere
    Vec3d p = fixtures::random_in_box(random, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
    if (trial % 2 == 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = 8 * tolerance * std::round(p[axis] / (8 * tolerance));
      p += fixtures::random_in_box(random, {-tolerance, -tolerance, -tolerance}, {tolerance, tolerance, tolerance});
    }
    const Vec3d direction = fixtures::random_direction(random);
    CHECK(merged(p, p + 0.999 * tolerance * direction, tolerance) == 1);
    CHECK(merged(p, p + 1.001 * tolerance * direction, tolerance) == 0);
  }
}

TEST_CASE("weld: in a dense cloud each vertex is merged into the nearest of those before, as by comparing all with all") {
  std::mt19937_64 random(2);
  for (const double tolerance : {0.0, 1e-9, 0.01, 0.05, 0.3, 3.0}) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 1500; ++k) {
      points.push_back(fixtures::random_in_box(random, {-1, -1, -1}, {1, 1, 1}));
      if (k % 3 == 0) points.push_back(points[std::size_t(k) / 2]);
    }
    const Welded welded = weld(cloud(points), tolerance);
    const ByHand expected = by_hand(points, tolerance);
    CHECK(welded.panels.vertices == expected.kept);
    for (std::size_t k = 0; k < points.size(); ++k) CHECK(welded.panels.panels[k][0] == expected.number[k]);
    CHECK(welded.merged + welded.panels.vertices.size() == points.size());
  }
}

TEST_CASE("weld: zeros of either sign coincide, and coincident vertices far from the origin are found") {
  CHECK(merged({0.0, 0, 0}, {-0.0, 0, 0}, 0) == 1);
  CHECK(merged({1e40, -1e40, 1e30}, {1e40, -1e40, 1e30}, 1e-9) == 1);
  CHECK(merged({1e40, -1e40, 1e30}, {1e40, -1e40, 1.1e30}, 1e-9) == 0);
}

TEST_CASE("weld: the seams of a body that was written triangle by triangle are closed, with noise below the tolerance too") {
  std::mt19937_64 random(3);
  const Panels torus = fixtures::torus(2, 0.5, 60, 30);
  const Panels noisy = fixtures::moved(fixtures::exploded(torus), [&](const Vec3d& v) { return v + 1e-10 * fixtures::random_direction(random); });
  const Welded welded = weld(noisy, 1e-9);
  CHECK(welded.panels.vertices.size() == torus.vertices.size());
  CHECK(fixtures::is_watertight(welded.panels));
}

TEST_CASE("weld: a distance closes the gaps left by rounding, and vertices farther apart stay separate") {
  // a cube whose faces are written one by one, with coordinates rounded to 1e-4 each in its own way
  Panels cube = fixtures::exploded(fixtures::unit_cube());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> slip(-5e-5, 5e-5);
  for (Vec3d& v : cube.vertices) v += Vec3d{slip(random), slip(random), slip(random)};
  CHECK_FALSE(Surface(cube, {.orientation = Orientation::normals}).is_closed());
  const Surface closed(cube, {.weld_distance = 2e-4});
  CHECK(closed.is_closed());
  CHECK(closed.report().vertices == 8);
  CHECK(closed.report().volume == fixtures::relative(1, 1e-3));  // corners moved by 1e-4
  CHECK_FALSE(Surface(cube, {.weld_distance = 1e-6, .orientation = Orientation::normals}).is_closed());
}
