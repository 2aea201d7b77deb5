// A point pushed for a hundred thousand steps by a rotating and translating surface: it never penetrates and never leaves it.
#include <doctest/doctest.h>

#include <array>

#include "fccda/evidence/shapes.hpp"
#include "fccda/evidence/truth.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fixtures/larger.hpp"

using namespace evidence;

namespace {

constexpr double pressed = 1e-4, slides = 3e-4;  // [m] per step

struct Push {
  std::size_t contacts = 0, panels = 0;     ///< panels: number of different panels in contact
  double lowest = 1e300, highest = -1e300;  ///< [m] height over the contact radius after a contact
  double gap = 0;                           ///< [m] the largest without contact, past an edge
};

/// In every step the point moves with the surface, is pressed against it and slides on it.
Push push(const Panels& panels, double radius, int steps) {
  const auto surface = fixtures::surface_of(panels);
  const Truth truth(*surface);
  Swept detector(surface, Unbounded{}, radius);
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {0.3, -0.2, 0.1}, {0.4, 0.3, 1}, {});
  fixtures::TestPoints points;
  points.x1 = {{0.3, 0.2, 0.6}};
  Push result;
  std::vector<bool> visited(surface->panels().panels.size(), false);
  Vec3d normal{};  // of the last contact, in the body frame; zero after it slid over an edge
  for (int step = 0; step < steps; ++step) {
    points.x0 = points.x1;
    const Motion motion = body.advance(1e-3);
    const Vec3d seen = motion.t0.to_body(points.x0[0]);
    // the direction of sliding rotates slowly, so that the point covers the surface
    const Vec3d along = cross(normal, {std::cos(0.0013 * step), std::sin(0.0017 * step), std::cos(0.0007 * step + 1)});
    const Vec3d towards = normal == Vec3d{} ? -(pressed + slides) * normalised(seen) : slides * along - pressed * normal;
    points.x1[0] = motion.t1.to_world(seen + towards);
    const std::vector<Contact> contacts = fixtures::detect(detector, points, motion, body.travel_bound(motion, 0.8));
    normal = contacts.empty() ? Vec3d{} : motion.t1.turn_to_body(contacts[0].normal);
    if (!contacts.empty()) points.x1[0] = contacts[0].relocation;
    const Vec3d place = motion.t1.to_body(points.x1[0]);
    const double distance = truth.distance(place), height = (truth.inside(place) ? -distance : distance) - radius;
    if (!contacts.empty()) {
      ++result.contacts;
      visited[static_cast<std::size_t>(contacts[0].panel)] = true;
      result.lowest = std::min(result.lowest, height), result.highest = fixtures::larger(result.highest, height);
    } else if (result.contacts > 0) {
      result.gap = fixtures::larger(result.gap, height);
    }
  }
  result.panels = static_cast<std::size_t>(std::count(visited.begin(), visited.end(), true));
  return result;
}

}  // namespace

TEST_CASE("evidence: a point pushed for 100 000 steps by a rotating and translating surface stays on it") {
  const Panels ball = make_sphere({.diameter = 1, .edge_length = 0.3});
  const Panels hull = fixtures::moved(ball, [](const Vec3d& p) {
    const double bump = 1 + 0.15 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
    return Vec3d{bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
  });
  const std::array<fixtures::Body, 3> bodies{{{"sphere", ball}, {"box", make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.6})}, {"hull", hull}}};
  constexpr std::array radii{0.0, 0.02};
  std::array<Push, 6> pushes;
  parallel_for_uneven(6, [&](std::ptrdiff_t n) {
    const auto k = static_cast<std::size_t>(n);
    pushes[k] = push(bodies[k / 2].panels, radii[k % 2], 100'000);
  });
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    const double radius = radii[k % 2];
    CAPTURE(std::string(bodies[k / 2].name));
    CAPTURE(radius);
    const Push& at = pushes[k];
    CHECK(at.contacts > 95'000);  // all except the approach and sliding over edges
    CHECK(at.panels > 10);
    CHECK(at.lowest > 0);
    // a ball rolls round edges; a point without extent may end a step past one
    CHECK(at.highest < (radius > 0 ? 2e-12 : pressed + slides));
    CHECK(at.gap < 2 * (pressed + slides));
  }
}
