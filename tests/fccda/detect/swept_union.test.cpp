// Overlapping closed parts: only the outside of their union is surface.
#include <doctest/doctest.h>

#include <algorithm>

#include "fccda/detect/scene.hpp"
#include "fccda/detect/swept.hpp"

using namespace fccda;
using fixtures::detect;
using fixtures::Soup;

namespace {

struct Assembly {
  std::vector<Panels> parts;
  std::shared_ptr<const Surface> surface;
  std::vector<Soup> soups;  // of each part separately

  explicit Assembly(std::vector<Panels> its) : parts(std::move(its)) {
    Panels all;
    for (const Panels& part : parts) {
      all = fixtures::joined(all, part);
      soups.emplace_back(Surface(part));
    }
    surface = fixtures::surface_of(all);
  }

  bool inside(const Vec3d& point) const {
    return std::any_of(soups.begin(), soups.end(), [&](const Soup& soup) { return soup.inside(point); });
  }
  template <class Place>
  double distance(const Place& place) const {
    double least = 1e300;
    for (const Soup& soup : soups) least = std::min(least, soup.distance(place));
    return least;
  }
};

Panels placed(const Panels& panels, const Vec3d& where, const Vec3d& rotation) {
  const Mat3 turn = Quaternion::from_rotation(rotation).matrix();
  return fixtures::moved(panels, [&](const Vec3d& p) { return turn * p + where; });
}

/// A cylindrical hub along z with four skewed blades embedded in it; the edge lengths of both are given.
Assembly propeller(double hub_panel, double blade_panel) {
  std::vector<Panels> parts{make_cylinder({.diameter = 0.3, .height = 0.3, .axis = Axis::z, .edge_length = hub_panel})};
  for (int blade = 0; blade < 4; ++blade) {
    const Panels plate = placed(make_box({.size = {0.4, 0.2, 0.02}, .edge_length = blade_panel}), {0.28, 0, 0}, {0, 0, 0});
    parts.push_back(placed(placed(plate, {}, {0.5, 0, 0}), {}, {0, 0, 0.5 * std::numbers::pi * blade}));
  }
  return Assembly(std::move(parts));
}

/// Boxes and cylinders that overlap at random.
Assembly heap(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Panels> parts;
  for (int k = 0; k < 5; ++k) {
    const double a = 0.1 + 0.3 * unit(random), b = 0.1 + 0.3 * unit(random), c = 0.03 + 0.2 * unit(random);
    const double panel = k % 2 == 0 ? 1 : 0.1;  // coarse panels are intersected, fine ones buried
    const Panels part =
        k < 3 ? make_box({.size = {a, b, c}, .edge_length = panel}) : make_cylinder({.diameter = a, .height = b, .axis = Axis::x, .edge_length = 0.1});
    parts.push_back(
        placed(part, fixtures::random_in_box(random, {-0.12, -0.12, -0.12}, {0.12, 0.12, 0.12}), 3 * unit(random) * fixtures::random_direction(random)));
  }
  return Assembly(std::move(parts));
}

std::vector<Assembly> assemblies() {
  std::vector<Assembly> all;
  all.push_back(propeller(0.1, 0.4));
  all.push_back(propeller(0.04, 0.05));
  for (std::uint64_t seed = 1; seed <= 6; ++seed) all.push_back(heap(seed));
  return all;
}

/// A random point near the surface, half of them near intersections of two parts.
Vec3d near_surface(const Assembly& assembly, double within, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0;; ++trial) {
    const auto& soup = assembly.soups[random() % assembly.soups.size()];
    const auto& t = soup.triangles[random() % soup.triangles.size()];
    const double u = unit(random), v = unit(random) * (1 - u);
    const Vec3d place = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) + within * unit(random) * fixtures::random_direction(random);
    std::size_t near = 0;
    for (const Soup& other : assembly.soups) near += other.distance(place) < 2 * within;
    if (near >= 2 || trial % 4 == 3) return place;
  }
}

}  // namespace

TEST_CASE("swept, overlapping parts: no contact is missed or false, and no point is left in any part, for points and for balls") {
  std::size_t seed = 0;
  for (const Assembly& assembly : assemblies()) {
    std::mt19937_64 random(++seed);
    CAPTURE(seed);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const double step = 0.06;
      std::vector<Path> paths;
      std::vector<bool> touches;
      while (paths.size() < 150) {
        Path path;
        path.start = near_surface(assembly, r + step, random);
        path.end = path.start + step * fixtures::random_direction(random);
        if (assembly.inside(path.start) || assembly.distance(path.start) < r + 1e-6) continue;
        const double distance = assembly.distance(path);
        const bool meets = r > 0 ? distance < r - 1e-6 : distance < 1e-9;
        if (!meets && distance < r + 1e-6) continue;
        paths.push_back(path), touches.push_back(meets);
      }
      Swept detector(assembly.surface, Unbounded{}, r);
      CHECK(detector.buried_triangles() > 0);
      std::vector<bool> found(paths.size(), false);
      for (const Contact& contact : detect(detector, fixtures::points_on(paths))) {
        found[contact.point] = true;
        CHECK_FALSE(assembly.inside(contact.relocation));
        CHECK(assembly.distance(contact.relocation) > r - 2e-12);  // the offset of 1e-12 of the size
        CHECK(contact.depth <= 2 * step + 2 * r);                  // at most the path length, there and back
        CHECK(std::fabs(norm(contact.normal) - 1) < 1e-12);
      }
      CHECK(found == touches);  // exact: no tolerance
    }
  }
}

TEST_CASE("swept, overlapping parts: a hundred thousand paths along the fillets end outside of all parts") {
  const Assembly assembly = propeller(0.15, 0.4);  // few panels, since the reference is slow
  std::mt19937_64 random(41);
  std::vector<Vec3d> fillet;  // points within a step of the hub and of a blade
  while (fillet.size() < 500) {
    const Vec3d place = near_surface(assembly, 0.02, random);
    if (!assembly.inside(place)) fillet.push_back(place);
  }
  std::vector<Path> paths;
  while (paths.size() < 100'000) {
    const Vec3d start = fillet[random() % fillet.size()];
    paths.push_back({start, start + 0.03 * fixtures::random_direction(random)});
  }
  Swept detector(assembly.surface, Unbounded{}, 0);
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on(paths));
  std::vector<const Contact*> of(paths.size(), nullptr);
  for (const Contact& contact : contacts) of[contact.point] = &contact;
  std::size_t resolved = 0, missed = 0, left_inside = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (of[i] == nullptr)
      missed += assembly.inside(paths[i].end);
    else
      left_inside += assembly.inside(of[i]->relocation), ++resolved;
  }
  CHECK(resolved > 20'000);
  CHECK(missed == 0);
  CHECK(left_inside == 0);
}

TEST_CASE("swept, overlapping parts: a point deep in the hub, beside a buried blade, is relocated straight above, not along the blade") {
  // a tall rod embedded in a block: the point ends 0.02 below the top of the block and 0.005 beside the rod
  const Assembly assembly(
      {make_box({.size = {1, 1, 0.4}, .edge_length = 0.1}), placed(make_box({.size = {0.1, 0.1, 1}, .edge_length = 0.1}), {0, 0, 0.5}, {})});
  Swept detector(assembly.surface, Unbounded{}, 0);
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on({{{0.055, 0.01, 0.21}, {0.055, 0.01, 0.18}}}));
  REQUIRE(contacts.size() == 1);
  CHECK(norm(contacts[0].relocation - Vec3d{0.055, 0.01, 0.2}) < 2e-12);  // the offset is 1.2e-12
  CHECK(norm(contacts[0].normal - Vec3d{0, 0, 1}) < 1e-9);
}

TEST_CASE("swept, overlapping parts: a point that goes into the hub through a thin blade stays on the side of the blade it came from") {
  const Assembly assembly({make_box({.size = {1, 1, 0.4}, .edge_length = 0.1}), placed(make_box({.size = {0.02, 1, 1}, .edge_length = 0.1}), {0, 0, 0.5}, {})});
  Swept detector(assembly.surface, Unbounded{}, 0);
  // ends nearer to the far face of the blade, at x = -0.01
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on({{{0.03, 0, 0.21}, {-0.005, 0.1, 0.15}}}));
  REQUIRE(contacts.size() == 1);
  CHECK(norm(contacts[0].relocation - Vec3d{0.01, 0.1, 0.2}) < 3e-12);  // the offset is 1.2e-12
}

TEST_CASE("swept, overlapping parts: inside is inside any of them, however deep in the others") {
  std::size_t seed = 50;
  for (const Assembly& assembly : assemblies()) {
    std::mt19937_64 random(++seed);
    CAPTURE(seed);
    fixtures::TestPoints points;
    std::vector<std::size_t> expected;
    while (points.size() < 1500) {
      const Vec3d place = near_surface(assembly, 0.05, random);
      if (assembly.distance(place) < 1e-8) continue;  // contact is not inside
      if (assembly.inside(place)) expected.push_back(points.size());
      points.x0.push_back(place);
    }
    CHECK(Swept(assembly.surface, Unbounded{}, 0).initial_overlap(points, Pose()) == expected);
    CHECK(expected.size() > 300);
  }
}

TEST_CASE("swept, overlapping parts: a point that slides along a fillet keeps sliding") {
  const Assembly assembly(
      {make_box({.size = {1, 1, 0.4}, .edge_length = 0.1}), placed(make_box({.size = {0.1, 1, 1}, .edge_length = 0.1}), {0, 0.2, 0.5}, {})});
  for (const double r : {0.0, 0.02}) {
    Swept detector(assembly.surface, Unbounded{}, r);
    fixtures::TestPoints points;
    points.x1 = {{0.05 + r + 1e-9, -0.2, 0.2 + r + 1e-9}};
    for (int step = 0; step < 100; ++step) {
      points.x0 = points.x1;
      points.x1[0] += Vec3d{-2e-4, 1e-3, -3e-4};  // along, and into both
      for (const Contact& contact : detect(detector, points)) points.x1[0] = contact.relocation;
    }
    CHECK(norm(points.x1[0] - Vec3d{0.05 + r, -0.1, 0.2 + r}) < 1e-9);
  }
}

TEST_CASE("swept, overlapping parts: the hollow of one part is outside unless another fills it") {
  // a box with a cubic hollow of 0.4, and a rod of 0.1 that runs right through
  const Panels wall = fixtures::joined(make_box({.size = {1, 1, 1}, .edge_length = 0.25}), make_box({.size = {0.4, 0.4, 0.4}, .edge_length = 0.1}));
  const Surface hollow(wall);
  REQUIRE(hollow.report().cavities == 1);
  REQUIRE(hollow.report().solids == 1);
  const auto surface = fixtures::surface_of(fixtures::joined(wall, make_box({.size = {0.1, 0.1, 2}, .edge_length = 0.1})));
  REQUIRE(surface->report().solids == 2);
  Swept detector(surface, Unbounded{}, 0);
  fixtures::TestPoints points;
  points.x0 = {{0.1, 0, 0}, {0.3, 0, 0}, {0, 0, 0}, {0, 0, 0.4}, {0, 0, 0.8}, {0.1, 0.1, 0.19}};
  points.x1 = points.x0;
  CHECK(detector.initial_overlap(points, Pose()) == std::vector<std::size_t>{1, 2, 3, 4});
}

TEST_CASE("swept, overlapping parts: the triangles that may be buried are counted, and a single part has no extra cost") {
  const Assembly apart({fixtures::box(), placed(fixtures::box(), {3, 0, 0}, {})});
  CHECK(Swept(apart.surface, Unbounded{}, 0).buried_triangles() == 0);
  CHECK(Swept(fixtures::surface_of(fixtures::hull()), Unbounded{}, 0).buried_triangles() == 0);
  // a rod of 0.1 × 0.1 × 1 in the middle of a box of height 0.4: of its panels, 0.1 long, more than half are above by more than
  // their own size
  const Assembly sunk({fixtures::box(), placed(make_box({.size = {0.1, 0.1, 1}, .edge_length = 0.1}), {0, 0, 0.5}, {})});
  const std::size_t buried = Swept(sunk.surface, Unbounded{}, 0).buried_triangles();
  CHECK(buried > 2 * (4 * 2 + 1));
  CHECK(buried < sunk.surface->triangles().size() / 3);
}
