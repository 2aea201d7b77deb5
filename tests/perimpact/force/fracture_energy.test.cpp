// Elastic energy released by bond failure, for every material.
#include <doctest/doctest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"

using namespace perimpact;

namespace {

constexpr double dt = 1e-7;  // [s]

/// A deformed body in motion, with or without bond failure.
Body shaken(fixtures::BodyOptions options, bool breaks) {
  if (breaks) options.critical_stretch = 5e-3;
  Body body = fixtures::body(options);
  fixtures::shake(body, 3e-6);
  fixtures::set_random_velocities(body, 10);
  return body;
}

/// Σ V f·v [W].
double power(const Body& body) {
  double sum = 0;
  for (const std::uint32_t slot : body.particles.slot_of())
    sum += body.particles.volume(slot) * dot(body.particles.force_density.at(slot), body.particles.velocity.at(slot));
  return sum;
}

constexpr Vec3d size{0.008, 0.007, 0.006};

}  // namespace

TEST_CASE("fracture energy: it is the difference of elastic energy at fixed positions with and without the broken bonds, for every material") {
  for (const fixtures::NamedOptions& one : fixtures::every_body(size)) {
    CAPTURE(one.name);
    Body whole = shaken(one.options, false), broken = shaken(one.options, true);
    const double before = whole.internal.evaluate_with_energy(whole.particles, whole.family);
    const double after = broken.internal.evaluate_with_energy(broken.particles, broken.family);
    REQUIRE(broken.internal.broken_bonds() > 0);
    REQUIRE(before - after > 0.001 * before);
    // rounding of sums over some ten thousand bonds, whose difference is a thousandth; correspondence inverts its shape tensors twice
    CHECK(broken.internal.fracture_energy() == fixtures::relative(before - after, 1e-9));
    CHECK(whole.internal.fracture_energy() == 0);

    broken.internal.evaluate(broken.particles, broken.family, dt);  // nothing is left to break
    CHECK(broken.internal.fracture_energy() == fixtures::relative(before - after, 1e-9));
  }
}

TEST_CASE("fracture energy: in motion it is reduced by the work of the lost forces over half a step") {
  for (const fixtures::NamedOptions& one : fixtures::every_body(size)) {
    CAPTURE(one.name);
    Body whole = shaken(one.options, false), broken = shaken(one.options, true);
    const double before = whole.internal.evaluate_with_energy(whole.particles, whole.family);
    const double after = broken.internal.evaluate_with_energy(broken.particles, broken.family, dt);
    const double lost = 0.5 * dt * (power(whole) - power(broken));
    REQUIRE(std::fabs(lost) > 1e-4 * (before - after));
    CHECK(broken.internal.fracture_energy() == fixtures::relative(before - after + lost, 1e-9));  // as above
  }
}

TEST_CASE("fracture energy: it is the same for scalar and packed evaluation, one thread and several") {
  for (const fixtures::NamedOptions& one : fixtures::every_body(size)) {
    CAPTURE(one.name);
    Body scalar = shaken(one.options, true);
    scalar.internal.evaluate_scalar(scalar.particles, scalar.family, dt);
    std::vector<double> found;
    for (const int threads : {1, 2, 4}) {
      const fixtures::Threads with_several(threads);
      Body wide = shaken(one.options, true);
      wide.internal.evaluate(wide.particles, wide.family, dt);
      found.push_back(wide.internal.fracture_energy());
    }
    CHECK(found[0] == found[1]);
    CHECK(found[0] == found[2]);
    CHECK(found[0] == fixtures::relative(scalar.internal.fracture_energy(), 1e-9));  // as above
  }
}
