#include "perimpact/device/boundary_conditions_on_device.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "perimpact/boundary_conditions/scene.hpp"
#include "perimpact/device/emulated_device.hpp"

using namespace perimpact;

TEST_CASE("boundary conditions on a device: the travel of blocks includes that of prescribed displacements, bitwise as on the host") {
  constexpr double dt = 1e-7;
  BodySetup setup = fixtures::body_setup({.size = {0.024, 0.006, 0.006}});
  DisplacementSetup course;
  course.velocity = 300;  // the other particles are slower by far
  setup.boundary_conditions = {{"pull", PrescribedSetup{.particle_set = "some", .y = course}}};
  // in part of the blocks, also in blocks that have free particles
  const fixtures::Regions some = {{"some", [](const Vec3d& X) { return X.x > 0.009 && X.z > 0; }}};
  fixtures::BoundedBody on_host(setup, some, dt), bounded(setup, some, dt);
  for (Body* body : {&on_host.body, &bounded.body}) fixtures::set_random_velocities(*body, 30);
  Particles &expected = on_host.body.particles, &particles = bounded.body.particles;
  EmulatedDevice device;
  BodyOnDevice body(device, bounded.body);
  BoundaryConditionsOnDevice boundary_conditions(device, body, bounded.body, bounded.boundary_conditions);
  const fccda::Step step{0, dt, dt};
  advance(expected, dt, on_host.travel);
  body.advance(particles, dt, bounded.travel);
  CHECK(bounded.travel == on_host.travel);
  const std::vector<double> without = on_host.travel;
  on_host.boundary_conditions.impose_displacements(expected, step, on_host.travel);
  boundary_conditions.impose_displacements(particles, step, bounded.travel);
  CHECK(bounded.travel == on_host.travel);
  CHECK(on_host.travel != without);
  body.to_host();
  for (const std::uint32_t slot : particles.slot_of()) {
    CHECK(particles.position.at(slot) == expected.position.at(slot));
    CHECK(particles.velocity.at(slot) == expected.velocity.at(slot));
  }
}
