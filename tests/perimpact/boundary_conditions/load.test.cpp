#include "perimpact/boundary_conditions/actions/load.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "fixtures/tolerance.hpp"
#include "perimpact/boundary_conditions/scene.hpp"

using namespace perimpact;
using fixtures::BoundedBody;

namespace {

constexpr double dt = 2e-7;  // [s]

Vec3d total_force(const Particles& particles) {
  Vec3d sum{};
  for (const std::uint32_t slot : particles.slot_of()) sum += particles.volume(slot) * particles.force_density.at(slot);
  return sum;
}

Choice face(int index) { return Choice{face_words, index}; }

}  // namespace

TEST_CASE("load: a free body falls by g t under its weight, whose work is its kinetic energy") {
  BodySetup setup = fixtures::body_setup({.size = {0.006, 0.006, 0.006}});
  setup.boundary_conditions = {{"weight", BodyForceSetup{.force_density = {0, 0, -9.81 * fixtures::density}}}};
  BoundedBody scene(setup, {}, dt);
  for (int step = 0; step < 50; ++step) scene.step();
  const double time = scene.clock.time();
  for (const std::uint32_t slot : scene.body.particles.slot_of())
    CHECK(scene.body.particles.velocity.at(slot).z == fixtures::relative(-9.81 * time, 1e-6));  // rounding of bonds moves them by as much
  const double mass = fixtures::density * 0.006 * 0.006 * 0.006;
  CHECK(scene.boundary_conditions.work() == fixtures::relative(scene.body.motion(dt).kinetic_energy_of_scheme, 1e-7));  // rounding of bonds, as above
  CHECK(scene.boundary_conditions.all()[0].account().force().z == fixtures::relative(-9.81 * mass, 1e-12));
}

TEST_CASE("load: a pressure on each face of a box adds up to pressure times area, against the face's normal") {
  for (int index = 0; index < 6; ++index) {
    BodySetup setup = fixtures::body_setup({.size = {0.01, 0.006, 0.004}});
    setup.boundary_conditions = {{"push", PressureSetup{.face = face(index), .value = 3e6}}};
    Body body = make_body(setup);
    BoundaryConditions boundary_conditions(setup, elastic_of(setup), body.particles, fixtures::slots_of(body.particles, {}));
    boundary_conditions.add_forces(body.particles, {0, dt, dt});
    const double areas[] = {0.006 * 0.004, 0.01 * 0.004, 0.01 * 0.006};
    Vec3d expected{};
    expected[static_cast<std::size_t>(index / 2)] = (index % 2 == 0 ? -3e6 : 3e6) * areas[index / 2];
    CAPTURE(index);
    CHECK(norm(total_force(body.particles) - expected) <= 1e-12 * norm(expected));  // rounding
  }
}

TEST_CASE("load: on a body of any shape pressure acts on the last particle of each row only") {
  Lattice lattice{.cells = {9, 9, 9}, .spacing = 0.001, .origin = {-0.004, -0.004, -0.004}};
  const Particles ball(lattice, 3, 1000, [](const Vec3d& X) { return norm(X) < 0.0042; });
  const std::vector<std::uint32_t> pressed = outermost(ball, ball.slot_of(), BodyFace(1));  // -x
  std::size_t rows = 0, last = 0;
  for (int j = 0; j < 9; ++j)
    for (int k = 0; k < 9; ++k)
      for (int i = 0; i < 9; ++i) {
        if (!ball.is_occupied(lattice.slot(i, j, k))) continue;
        ++rows;  // the first occupied from -x
        last += std::binary_search(pressed.begin(), pressed.end(), static_cast<std::uint32_t>(lattice.slot(i, j, k)));
        break;
      }
  CHECK(pressed.size() == rows);
  CHECK(last == rows);
}

TEST_CASE("load: a given area replaces that of the cells, and factors are interpolated") {
  BodySetup setup = fixtures::body_setup({.size = {0.01, 0.006, 0.004}});
  setup.boundary_conditions = {{"pull", PressureSetup{.face = face(0), .value = -2e6, .area = 1e-5, .times = {0, 4 * dt}, .factors = {0, 2}}}};
  Body body = make_body(setup);
  BoundaryConditions boundary_conditions(setup, elastic_of(setup), body.particles, fixtures::slots_of(body.particles, {}));
  boundary_conditions.add_forces(body.particles, {dt, 2 * dt, dt});
  CHECK(total_force(body.particles).x == fixtures::relative(0.5 * 2e6 * 1e-5, 1e-12));  // rounding
}
