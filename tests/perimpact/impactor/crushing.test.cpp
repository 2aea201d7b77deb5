// Material that impactors crush between a particle's centre and its face (contact.impactors.crushing_pressure).
#include "fccda/respond/crushing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::relative;

namespace {

constexpr double spacing = 0.002, radius = spacing / 2, pressure = 1e7, gap = 0.1 * radius;  // [m], [Pa]
constexpr int across = 4;                                                                    // particles

/// A block on a fixed layer, and a box above it that moves down by a table; its face is larger than that of the block.
Setup pressed(TranslationTable down) {
  Setup setup;
  setup.time = {.end = down.times.back(), .step = 1e-7};
  const double edge = across * spacing;
  BodySetup block = fixtures::body_setup({.size = {edge, edge, edge}, .spacing = spacing, .model = fixtures::Model::bond_based});
  block.particle_sets = {{.name = "base", .shape = BoxSolid{{1, 1, spacing}}, .position = {0, 0, -edge / 2 + spacing / 2}}};
  block.boundary_conditions = {{"base", FixedSetup{.particle_set = "base"}}};
  setup.bodies = {block};
  ImpactorSetup box;
  box.name = "box";
  box.surface = BoxSurface{.size = {3 * edge, 3 * edge, edge}, .edge_length = edge};
  box.mass = 1;
  box.position = {0, 0, edge + gap};
  box.motion.z = std::move(down);
  setup.impactors = {box};
  setup.contact.impactors.crushing_pressure = pressure;
  setup.output.history_interval = 1e-5;
  return setup;
}

TranslationTable at_speeds(std::vector<double> times, std::vector<double> speeds) { return TranslationTable{{std::move(times), std::move(speeds), {}, {}}}; }

constexpr double face = across * across * spacing * spacing;  // [m²]

}  // namespace

TEST_CASE("crushing: the force of a slow box grows with the crushed depth to the pressure on the face of the block") {
  constexpr double speed = 2;  // [m/s]
  Simulation simulation(pressed(at_speeds({0, 0.9 * radius / speed}, {-speed, -speed})));
  int compared = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    // a row is the mean over its interval
    const double depth = speed * (simulation.clock().time() - 0.5e-5) - gap, force = fixtures::value(simulation, "box.force_z [N]");
    if (depth < 0.1 * radius) continue;
    // the block yields elastically by force/(E edge) = 4e-5 of its height, some 1e-3 of the depth, and vibrates after first contact
    CHECK(force == relative(pressure * face * depth / radius, 0.01));
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("crushing: what it dissipates is force times depth, and the energy balance closes") {
  constexpr double speed = 2;
  Simulation simulation(pressed(at_speeds({0, 1.05 * radius / speed}, {-speed, -speed})));
  fixtures::run(simulation);
  const double depth = speed * simulation.clock().time() - gap;
  const double expected = 0.5 * pressure * face * depth * depth / radius;
  CHECK(fixtures::value(simulation, "total.contact_dissipation [J]") == relative(expected, 0.01));  // as the force
  CHECK(fixtures::value(simulation, "box.crushing_dissipation [J]") == relative(expected, 0.01));
  CHECK(std::fabs(fixtures::value(simulation, "total.energy_balance_error [J]")) < 1e-3 * expected);
}

TEST_CASE("crushing: a box that withdraws and returns meets what is left, and contact is rigid once a particle is crushed to its centre") {
  constexpr double speed = 2, half = 0.5 * radius;
  // down by gap + half, up by half, down to a depth of 1.02 radii
  const double down = (gap + half) / speed, up = half / speed, again = (half + 0.52 * radius) / speed;
  constexpr double turn = 1e-7;  // [s]
  Simulation simulation(
      pressed(at_speeds({0, down, down + turn, down + up, down + up + turn, down + up + again}, {-speed, -speed, speed, speed, -speed, -speed})));
  double while_away = 0, before_rigid = 0, largest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    const double time = simulation.clock().time(), force = fixtures::value(simulation, "box.force_z [N]");
    const double depth = speed * (time - down - 2 * up) + half;  // on the second way down
    if (time > down + 2e-5 && depth < 0.9 * half) while_away = std::max(while_away, std::fabs(force));
    if (depth > half && depth < 0.95 * radius) before_rigid = std::max(before_rigid, force);
    largest = std::max(largest, force);
  }
  CHECK(while_away < 0.01 * pressure * face);
  CHECK(before_rigid > 0.7 * pressure * face);
  CHECK(before_rigid < 1.02 * pressure * face);
  // crushed to the centres, the block is compressed by 0.02 radii: E 0.02 r/(7/8 height) on the face, five times the pressure, in an elastic block
  CHECK(largest > 1.5 * pressure * face);
  for (const std::uint32_t slot : simulation.bodies()[0].particles.slot_of()) {
    const double crushed = simulation.bodies()[0].particles.crushed[slot];
    const bool is_top = simulation.bodies()[0].particles.reference(slot).z > 1.2 * spacing;
    CHECK(crushed == fixtures::absolute(is_top ? 0.999 * radius : 0, 1e-9 * radius, "m"));
  }
}

TEST_CASE("crushing: a free ball and a free block exchange momentum to rounding, and the force of a particle is at most the pressure on its face") {
  Setup setup = pressed(at_speeds({0, 4e-4}, {0, 0}));
  setup.bodies[0].boundary_conditions.clear();
  ImpactorSetup& ball = setup.impactors[0];
  ball.surface = SphereSurface{.diameter = 0.02, .edge_length = 0.001};
  ball.motion = {};
  ball.position = {0.0007, 0.0004, across * spacing / 2 + 0.01 + gap};
  ball.velocity = {0.5, 0, -3};
  ball.mass = 0.01;
  ball.free_dofs = {"x", "y", "z", "rx", "ry", "rz"};
  setup.contact.impactors.friction = 0.2;
  Simulation simulation(setup);
  const auto momentum = [&](const char* axis) { return fixtures::value(simulation, std::string("total.momentum_") + axis + " [kg m/s]"); };
  const std::array<double, 2> before{momentum("x"), momentum("z")};
  double largest = 0;
  std::size_t contacts = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    for (const ContactImpulse& one : simulation.impactors()[0].last_step().contact_impulses) {
      const double force = dot(one.impulse, -1.0 * one.contact.normal) / simulation.clock().dt;
      if (one.contact.radius > 0.01 * radius) largest = std::max(largest, force), ++contacts;
    }
  }
  CHECK(contacts > 1000);
  CHECK(largest <= pressure * spacing * spacing * (1 + 1e-9));
  CHECK(largest > 0.3 * pressure * spacing * spacing);
  CHECK(simulation.impactors()[0].unconverged_steps() == 0);
  CHECK(std::fabs(momentum("x") - before[0]) < 1e-12 * std::fabs(before[1]));  // thousands of roundings
  CHECK(std::fabs(momentum("z") - before[1]) < 1e-12 * std::fabs(before[1]));
  CHECK(fixtures::value(simulation, "box.velocity_z [m/s]") > -2.9);
}

TEST_CASE("crushing: in a concave corner the force on a particle does not exceed the pressure on its face, and no wall is passed") {
  // an L closes on an edge of the block, one wall twenty times as fast as the other; corner at the origin, material at x > 0 or y > 0
  const ::fixtures::TemporaryFolder folder;
  std::string file;
  for (const char* z : {"-0.02", "0.02"})
    for (const char* place : {"0 -0.02", "0.01 -0.02", "0.01 0.01", "-0.02 0.01", "-0.02 0", "0 0"}) file += std::string("v ") + place + " " + z + "\n";
  file += "f 7 8 9 12\nf 12 9 10 11\nf 6 3 2 1\nf 5 4 3 6\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
  ::fixtures::put(folder / "corner.obj", file);
  Setup setup = pressed(at_speeds({0, 0.7 * radius / 2}, {0, 0}));
  const double edge = across * spacing, gap_y = 1e-3 * radius;  // both walls arrive in the same step
  setup.bodies[0].particle_sets = {{.name = "base", .shape = BoxSolid{{0.5 * edge, 0.5 * edge, 1}}, .position = {-0.25 * edge, -0.25 * edge, 0}}};
  ImpactorSetup& corner = setup.impactors[0];
  corner.surface = FileSurface{.file = (folder / "corner.obj").string()};
  corner.motion = {}, corner.position = {edge / 2 + 20 * gap_y, edge / 2 + gap_y, 0}, corner.velocity = {-2, -0.1, 0};
  Simulation simulation(setup);
  double largest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    for (const ContactImpulse& one : simulation.impactors()[0].last_step().contact_impulses)
      largest = std::max(largest, norm(one.impulse) / simulation.clock().dt);
  }
  CHECK(simulation.impactors()[0].unresolved(0).count == 0);
  Particles particles = simulation.bodies()[0].particles;
  CHECK(simulation.impactors()[0].initial_overlap(0, ContactParticles(particles, setup.contact.impactors, {}, 0)).empty());
  CHECK(largest > 0.5 * pressure * spacing * spacing);
  CHECK(largest < 1.01 * pressure * spacing * spacing);
}

TEST_CASE("crushing: an open surface is refused with the reason") {
  Setup setup = pressed(at_speeds({0, 4e-4}, {0, 0}));
  const ::fixtures::TemporaryFolder folder;
  ::fixtures::put(folder / "sheet.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  setup.impactors[0].surface =
      FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  setup.impactors[0].inertia = Vec3d{1, 1, 1};
  CHECK(fixtures::complaint(setup) ==
        "contact.impactors.crushing_pressure: impactor box has an open surface, which excludes crushing_pressure; close it, or remove crushing_pressure.");
}

TEST_CASE("crushing: an impactor that deforms is refused with the reason") {
  const Setup setup = pressed(at_speeds({0, 4e-4}, {0, 0}));
  Impactor impactor(setup.impactors[0], setup.contact.impactors, {});
  try {
    impactor.make_external({}, {});
    FAIL("accepted");
  } catch (const SetupError& error) {
    CHECK(error.key() == "contact.impactors.crushing_pressure");
    CHECK(std::string(error.what()) == "impactor box deforms, which excludes crushing_pressure; remove it.");
  }
}

TEST_CASE("crushing: a particle is never pushed more than by rigid contact, nor crushed beyond its centre") {
  for (const double push : {0.0, 0.3, 5.0, 1e3})
    for (const double depth : {0.0, 4e-4, 1e-3})
      for (const double stiffness : {0.0, 1e3, 1e9}) {
        const double left = 1e-3 - depth, mass = 2e-5, dt = 1e-6;
        const fccda::Crushed found = fccda::crushed({stiffness, depth, left}, push, mass, dt);
        CHECK(found.push <= push);
        CHECK(found.push >= 0);
        CHECK(found.depth <= left);
        // momentum and way agree: what is not pushed is crushed
        CHECK(found.depth == fixtures::absolute((push - found.push) * dt, 1e-12, "m"));
        if (found.depth > 0 && found.depth < left)
          CHECK(mass * found.push == fixtures::absolute(stiffness * (depth + found.depth) * dt, 1e-9 * mass * push, "N s"));
      }
}
