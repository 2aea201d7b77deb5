#include "fccda/detect/analytic.hpp"

#include <doctest/doctest.h>

#include "fccda/detect/scene.hpp"
#include "fccda/detect/swept.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

std::vector<Path> random_paths(std::size_t count, double step, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> distance(0.53, 0.6);
  std::vector<Path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d start = distance(random) * fixtures::random_direction(random);
    paths.push_back({start, start + step * fixtures::random_direction(random)});
  }
  return paths;
}

}  // namespace

TEST_CASE("analytic: points that end nearer to the centre than R + r, or pass right through, are in contact, however long the step") {
  for (const double step : {0.05, 3.0}) {
    const std::vector<Path> paths = random_paths(5000, step, 31);
    Analytic detector(Sphere{.radius = 0.5}, Unbounded{}, 0.02);
    std::vector<bool> found(paths.size(), false);
    for (const Contact& contact : detect(detector, fixtures::points_on(paths))) {
      found[contact.point] = true;
      CHECK(norm(contact.relocation) == fixtures::relative(0.52, 1e-11));  // R + r and the offset
      CHECK(norm(contact.hit) == fixtures::relative(0.5, 1e-11));
      CHECK(contact.radius == 0.02);
      CHECK(dot(contact.relocation, paths[contact.point].start) > 0);  // never relocated to the far side
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
      double nearest = 1e300;  // of a thousand points along the path
      for (int k = 0; k <= 1000; ++k) nearest = std::min(nearest, norm(paths[i].at(k / 1000.0)));
      if (std::fabs(nearest - 0.52) < 1e-4) continue;  // undecided by sampling: points are 3e-3 apart, (3e-3)²/8R off
      const bool far_side = dot(paths[i].start, paths[i].end) < 0;
      CHECK(found[i] == (norm(paths[i].end) < 0.52 || (far_side && nearest < 0.52)));
    }
  }
}

TEST_CASE("analytic: contact with a cylinder counts along its whole axis, within the contact bounds") {
  const auto surface = fixtures::surface_of(fixtures::cylinder());
  const BoxUnion region({.size = {2, 2, 0.2}}, *surface, Beyond::clip);
  Analytic detector(InfiniteCylinder{.radius = 0.5}, region, 0.01);
  const std::vector<Path> paths{
      {{0.6, 0, 0.05}, {0.4, 0, 0.05}}, {{0.6, 0, 0.15}, {0.4, 0, 0.15}}, {{0.6, 0, 0}, {0.52, 0, 0}}, {{0.6, 0.3, 0}, {0.4, 0.3, 0}}};
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on(paths));
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[0].point == 0);
  CHECK(norm(contacts[0].relocation - Vec3d{0.51, 0, 0.05}) < 1e-11);
  CHECK(contacts[1].point == 3);
}

TEST_CASE("analytic: motion away from the surface after contact is not contact, motion inward again is") {
  Analytic detector(Sphere{.radius = 0.5}, Unbounded{}, 0);
  const std::vector<Contact> contacts = detect(detector, fixtures::points_on(random_paths(2000, 0.1, 32)));
  REQUIRE(contacts.size() > 200);
  fixtures::TestPoints away, again;
  for (const Contact& contact : contacts) {
    away.x0.push_back(contact.relocation);
    away.x1.push_back(contact.relocation + 1e-3 * contact.normal);
    again.x0.push_back(contact.relocation);
    again.x1.push_back(contact.relocation - 1e-3 * contact.normal);
  }
  CHECK(detect(detector, away).empty());
  CHECK(detect(detector, again).size() == contacts.size());
}

TEST_CASE("analytic: the mesh of a sphere converges to it with the square of the panel size") {
  const std::vector<Path> paths = random_paths(1000, 0.15, 33);
  const auto error = [&](double panel) {
    Swept mesh(fixtures::surface_of(make_sphere({.diameter = 1, .edge_length = panel})), Unbounded{}, 0);
    Analytic exact(Sphere{.radius = 0.5}, Unbounded{}, 0);
    const std::vector<Contact> a = detect(mesh, fixtures::points_on(paths)), b = detect(exact, fixtures::points_on(paths));
    double most = 0;
    for (const Contact& p : a)
      for (const Contact& q : b)
        if (p.point == q.point && q.depth > 1e-3) most = fixtures::larger(most, std::fabs(norm(p.relocation) - norm(q.relocation)));
    return most;
  };
  const double coarse = error(0.1), fine = error(0.05);
  CHECK(coarse < 0.1 * 0.1 / 2);  // the sagitta of a panel, panel²/(8R), and of its diagonal
  CHECK(coarse / fine > 3);
}
