// Containers, as in docs/library/recipes.md: points stay within.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fixtures/surfaces.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"

using namespace fccda;

namespace {

constexpr double radius = 0.03;  // [m]

/// Balls that fly about in a container, which shakes or turns. Returns the number of contacts.
template <class IsWithin>
std::size_t expect_kept(const Surface& container, const Vec3d& velocity, const Vec3d& spin, double gravity, const IsWithin& is_within) {
  ContactDetector detector(container, {.radius = radius});
  RigidBody body({.mass = 1}, Pose(), velocity, spin, {});
  std::mt19937_64 random(11);
  std::vector<Vec3d> x_t0, x, v;
  for (int k = 0; k < 100; ++k) {
    x.push_back(fixtures::random_in_box(random, {-0.5, -0.4, -0.4}, {0.5, 0.4, 0.4}));
    v.push_back(fixtures::random_in_box(random, {-2, -2, -2}, {2, 2, 0}));
  }
  CHECK(detector.points_inside(body.pose(), x).empty());
  const double dt = 0.01;
  std::size_t contacts = 0;
  for (int step = 0; step < 300; ++step) {
    x_t0 = x;
    for (std::size_t k = 0; k < x.size(); ++k) v[k].z -= gravity * dt, x[k] += dt * v[k];
    const Motion motion = body.advance(dt);
    contacts += respond(detector.detect(motion, x_t0, x), motion, body, {x_t0, x, v, 1e-3}, 0.3).contacts;
  }
  for (const Vec3d& place : x) CHECK(is_within(body.pose().to_body(place)));
  return contacts;
}

}  // namespace

TEST_CASE("containers: balls stay in a tray, which is open at the top and declared as reversed, and in a drum with a wall of some thickness") {
  Panels tray = make_box({.size = {2, 1, 1}});
  std::erase_if(tray.panels, [&](const auto& panel) {
    return std::ranges::all_of(panel, [&](int vertex) { return vertex < 0 || tray.vertices[static_cast<std::size_t>(vertex)].z > 0.499; });
  });
  REQUIRE(tray.panels.size() == 10);
  const auto in_tray = [](const Vec3d& x) { return std::fabs(x.x) < 1 - radius && std::fabs(x.y) < 0.5 - radius && x.z > -0.5 + radius; };
  CHECK(expect_kept(Surface(tray, {.orientation = Orientation::reversed}), {0.2, 0.1, 0}, {}, 9.81, in_tray) > 1000);

  Panels drum = make_cylinder({.diameter = 2.2, .height = 3.2, .axis = Axis::x});
  const Panels inside = make_cylinder({.diameter = 2, .height = 3, .axis = Axis::x});
  const int first = static_cast<int>(drum.vertices.size());
  drum.vertices.insert(drum.vertices.end(), inside.vertices.begin(), inside.vertices.end());
  for (auto panel : inside.panels) {
    for (int& vertex : panel) vertex += vertex < 0 ? 0 : first;
    drum.panels.push_back(panel);
  }
  drum.part.clear(), drum.part_names.clear();
  const Surface container(drum);
  CHECK(container.report().cavities == 1);
  // panels are chords: the distance from the axis is at most that of a ball at a vertex
  const auto in_drum = [](const Vec3d& x) { return std::fabs(x.x) < 1.5 - radius && std::hypot(x.y, x.z) < 1 - radius; };
  CHECK(expect_kept(container, {}, {3, 0, 0}, 9.81, in_drum) > 1000);
}
