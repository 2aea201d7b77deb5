#include "perimpact/body/sample.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"

using namespace perimpact;

TEST_CASE("sample: a point is evaluated at the nearest particles, inside the body, in its holes and far outside, in space and in a plane") {
  std::mt19937_64 random(3);
  for (const Plane plane : {Plane::none, Plane::strain})
    for (const fixtures::Points points : {fixtures::Points::lattice, fixtures::Points::shaken}) {
      fixtures::BodyOptions options{.plane = plane, .points = points};
      if (plane != Plane::none) options.size.z = options.spacing;
      Body body = fixtures::body(options);
      std::vector<std::size_t> removed;  // two thirds of the particles beyond the middle
      for (const std::uint32_t slot : body.particles.slot_of())
        if (body.particles.reference(slot).x > 0 && slot % 3 != 0) removed.push_back(slot);
      body.particles.remove(removed);
      for (const double size : {0.02, 0.3}) {
        std::uniform_real_distribution<double> within(-size, size);
        for (int trial = 0; trial < 200; ++trial) {
          const Vec3d point{within(random), within(random), within(random)};
          double nearest = std::numeric_limits<double>::infinity();
          Vec3d mean{};
          for (const std::uint32_t slot : body.particles.slot_of()) nearest = std::min(nearest, norm(body.particles.reference(slot) - point));
          int count = 0;
          for (const std::uint32_t slot : body.particles.slot_of()) {
            body.particles.position.set(slot, body.particles.reference(slot) + Vec3d{1e-6 * (slot + 1), 0, 0});
            if (norm(body.particles.reference(slot) - point) <= nearest + 1e-6 * body.particles.spacing()) mean += body.particles.displacement(slot), ++count;
          }
          const Sample sample(body, point);
          CHECK(sample.distance() >= nearest);
          CHECK(sample.distance() <= nearest + 1e-6 * body.particles.spacing());
          CHECK(sample.displacement(body).x == fixtures::relative(mean.x / count, 1e-9));
        }
      }
    }
}
