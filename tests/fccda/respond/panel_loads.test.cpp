#include "fccda/respond/panel_loads.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fccda/detect/scene.hpp"
#include "fccda/respond/nested_areas.hpp"
#include "fccda/respond/respond.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

/// The panel of a box of quads, centred on the origin, whose centre is nearest to `place`.
int panel_at(const PanelFaces& faces, const Vec3d& place) {
  std::size_t best = 0;
  for (std::size_t p = 0; p < faces.size(); ++p)
    if (norm(faces[p].middle - place) < norm(faces[best].middle - place)) best = p;
  return static_cast<int>(best);
}

/// A unit cube in square panels; its top is z = 0.5.
Surface cube(double panel) { return Surface(make_box({.size = {1, 1, 1}, .edge_length = panel, .panels = PanelKind::quads})); }

constexpr Vec3d up{0, 0, 1};

PanelLoad sum(const std::vector<PanelLoad>& loads) {
  PanelLoad total;
  for (const PanelLoad& load : loads) total += load;
  return total;
}

}  // namespace

TEST_CASE("panel loads: an impulse on a panel larger than the point's face gives J/(A T) there and nothing elsewhere") {
  PanelLoads loads(cube(0.25), std::vector<double>{0.01});
  const int panel = panel_at(loads.faces(), {0.1, 0.1, 0.5});
  loads.add(0, {.panel = panel, .normal = up}, {0.5, 0, -3});
  loads.end_interval(0.2);
  for (std::size_t p = 0; p < loads.faces().size(); ++p)
    if (static_cast<int>(p) == panel)
      CHECK(loads.interval_pressure()[p] == fixtures::relative(3 / (0.0625 * 0.2), 1e-14));  // three products
    else
      CHECK(loads.interval_pressure()[p] == 0);
  CHECK(loads.since_start()[static_cast<std::size_t>(panel)].impulse == Vec3d{0.5, 0, -3});
}

TEST_CASE("panel loads: the peak is the largest interval mean of each panel, also of panels that are unloaded later") {
  PanelLoads loads(cube(0.25), std::vector<double>{0.01});
  const auto panel = static_cast<std::size_t>(panel_at(loads.faces(), {0.1, 0.1, 0.5}));
  const double per_push = 1 / 0.0625;  // [Pa s] of 1 N s
  for (const double push : {1.0, 4.0, 2.0}) {
    loads.add(0, {.panel = static_cast<int>(panel), .normal = up}, {0, 0, -push / 2});
    loads.add(0, {.panel = static_cast<int>(panel), .normal = up}, {0, 0, -push / 2});
    loads.end_interval(0.5);
    CHECK(loads.interval_pressure()[panel] == fixtures::relative(push * per_push / 0.5, 1e-14));
  }
  loads.end_interval(0.5);
  CHECK(loads.interval_pressure()[panel] == 0);
  CHECK(loads.peak_pressure()[panel] == fixtures::relative(4 * per_push / 0.5, 1e-14));
  CHECK(loads.since_start()[panel].normal_impulse == fixtures::relative(7, 1e-14));
}

TEST_CASE("panel loads: on panels much smaller than the point's face an impulse gives a uniform pressure over a disc of the face's area") {
  constexpr double face = 0.04, push = 2, time = 0.1;
  PanelLoads loads(cube(0.02), std::vector<double>{face});
  loads.add(0, {.panel = panel_at(loads.faces(), {0.11, 0.07, 0.5}), .normal = up}, {0, 0, -push});
  loads.end_interval(time);
  double area = 0, force = 0;
  for (std::size_t p = 0; p < loads.faces().size(); ++p) {
    const double pressure = loads.interval_pressure()[p];
    if (pressure == 0) continue;
    area += loads.faces()[p].area;
    force += pressure * loads.faces()[p].area;
    CHECK(norm(loads.faces()[p].middle - Vec3d{0.11, 0.07, 0.5}) <= std::sqrt(face / std::numbers::pi) + 1e-12);
    CHECK(pressure == fixtures::relative(push / time / face, 0.1));  // squares fill a disc of 100 of them to within the ring at its edge
  }
  CHECK(area == fixtures::relative(face, 0.1));  // likewise
  CHECK(force == fixtures::relative(push / time, 1e-12));
}

TEST_CASE(
    "panel loads: distribution over the panels of a hull preserves the sum of the impulses of two bodies, to rounding, with the interval open or closed") {
  const auto surface = fixtures::surface_of(fixtures::hull());
  PanelLoads loads(*surface, std::vector<double>{0.02, 0.0005});
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> size(0, 1);
  PanelLoad expected;
  double magnitude = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto t = random() % surface->triangles().size();
    const Vec3d impulse = size(random) * fixtures::random_direction(random), normal = surface->normal(t);
    loads.add(random() % 2, {.panel = surface->triangles()[t].panel, .normal = normal}, impulse);
    expected += {impulse, -dot(impulse, normal)};
    magnitude += norm(impulse);
    if (k % 1000 == 500) loads.end_interval(0.1);
    if (k % 1700 != 0) continue;
    const PanelLoad total = sum(loads.since_start());
    const double tolerance = 1e-13 * (1 + magnitude);  // thousands of sums, each rounded to 1e-16 of what it adds
    CHECK(norm(total.impulse - expected.impulse) <= tolerance);
    CHECK(std::fabs(total.normal_impulse - expected.normal_impulse) <= tolerance);
  }
}

TEST_CASE("panel loads: an impulse near an edge is not distributed round the edge") {
  PanelLoads loads(cube(0.02), std::vector<double>{0.04});
  loads.add(0, {.panel = panel_at(loads.faces(), {0.49, 0, 0.5}), .normal = up}, {0, 0, -1});
  loads.end_interval(1);
  double force = 0;
  std::size_t loaded = 0;
  for (std::size_t p = 0; p < loads.faces().size(); ++p) {
    if (loads.interval_pressure()[p] == 0) continue;
    CHECK(loads.faces()[p].normal.z > 0.99);
    force += loads.interval_pressure()[p] * loads.faces()[p].area;
    ++loaded;
  }
  CHECK(loaded > 1);
  CHECK(force == fixtures::relative(1, 1e-12));
}

TEST_CASE("panel loads: the reports of respond() sum to the impulse on the body") {
  const auto surface = fixtures::surface_of(fixtures::hull());
  PanelLoads loads(*surface, std::vector<double>{0.01});
  Swept detector(surface, Unbounded{}, 0.01);
  RigidBody body({.mass = 5}, Pose(), {}, {}, {{true, true, true}});
  fixtures::TestPoints points;
  std::mt19937_64 random(32);
  for (int k = 0; k < 500; ++k) {
    const Vec3d direction = fixtures::random_direction(random);
    points.x0.push_back(direction);
    points.v.push_back(-8.0 * direction);
    points.m.push_back(0.001 * (1 + k % 7));
    points.x1.push_back(points.x0.back() + 0.1 * points.v.back());
  }
  const Motion motion = body.advance(0.1);
  const std::vector<Contact> contacts = fixtures::detect(detector, points, motion);
  respond(points, std::span<const Contact>(contacts), motion, body, 0.2, [&](const Contact& contact, const Vec3d& impulse) { loads.add(0, contact, impulse); });
  CHECK(contacts.size() > 400);
  CHECK(norm(sum(loads.since_start()).impulse - body.momentum()) <= 1e-12);  // hundreds of sums of numbers below 0.1
}

TEST_CASE("nested areas: around a known peak the mean pressure falls as the area grows, to the total force over the total area") {
  const PanelFaces faces(cube(0.1));
  std::vector<double> pressure(faces.size(), 0);
  double force = 0, area = 0;
  for (std::size_t p = 0; p < faces.size(); ++p) {  // a cone of pressure on the top, about a panel's middle
    const Vec3d from = faces[p].middle - Vec3d{0.05, 0.05, 0.5};
    if (faces[p].normal.z < 0.5 || norm(from) > 0.31) continue;
    pressure[p] = 1e6 * (1 - norm(from));
    force += 0.01 * pressure[p], area += 0.01;
  }
  const std::vector<NestedArea> nested = nested_areas(faces, pressure, 20);
  REQUIRE(nested.size() >= 10);  // fewer than requested: small areas are whole panels
  CHECK(nested.size() <= 20);
  CHECK(nested.front().area == fixtures::relative(0.01, 1e-12));
  CHECK(nested.front().mean_pressure == fixtures::relative(1e6, 1e-12));
  CHECK(nested[1].mean_pressure == fixtures::relative(1e6 * (1 + 0.9) / 2, 1e-12));  // with one of its four neighbours
  CHECK(nested.back().area == fixtures::relative(area, 1e-12));
  CHECK(nested.back().mean_pressure == fixtures::relative(force / area, 1e-12));
  for (std::size_t k = 1; k < nested.size(); ++k) {
    CHECK(nested[k].area > nested[k - 1].area);
    CHECK(nested[k].mean_pressure < nested[k - 1].mean_pressure);
  }
}

TEST_CASE("nested areas: an unloaded gap between two loaded panels is crossed and counts as area, and no load gives no areas") {
  const PanelFaces faces(cube(0.1));
  std::vector<double> pressure(faces.size(), 0);
  CHECK(nested_areas(faces, pressure, 20).empty());
  pressure[static_cast<std::size_t>(panel_at(faces, {0.05, 0.05, 0.5}))] = 4;
  CHECK(nested_areas(faces, pressure, 20).size() == 1);
  pressure[static_cast<std::size_t>(panel_at(faces, {0.25, 0.05, 0.5}))] = 2;
  const std::vector<NestedArea> nested = nested_areas(faces, pressure, 100);
  CHECK(nested.back().area >= 0.03 - 1e-12);  // at least the one between them; all at its distance come before or after by their number
  CHECK(nested.back().area <= 0.13);          // and nothing further from the first than the second, of which there are 12
  CHECK(nested.back().mean_pressure * nested.back().area == fixtures::relative(0.06, 1e-12));
}
