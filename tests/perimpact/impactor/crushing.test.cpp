// Material that impactors crush (contact.impactors.crushing_pressure).
#include "fccda/respond/crushing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fixtures/larger.hpp"
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

/// [N] of a layer of the block at a crushed depth [m]: the pressure on the section of its balls, scaled to the volume of the layer.
double force_at(double depth) { return 6 * pressure * face * (depth / spacing) * (1 - depth / spacing); }

TEST_CASE("crushing: the force of a slow box is the pressure on the section of the balls of the block, layer by layer") {
  constexpr double speed = 2;  // [m/s]
  Simulation simulation(pressed(at_speeds({0, (gap + 1.5 * spacing) / speed}, {-speed, -speed})));
  int compared = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    // a row is the mean over its interval
    const double depth = speed * (simulation.clock().time() - 0.5e-5) - gap, force = fixtures::value(simulation, "box.force_z [N]");
    const double of_layer = std::fmod(depth, spacing);
    if (of_layer < 0.1 * spacing || of_layer > 0.9 * spacing) continue;
    // the block yields elastically by force/(E edge) = 6e-5 of its height, some 1e-3 of the depth; it vibrates after first contact and when a layer is lost
    CHECK(force == relative(force_at(of_layer), 0.02));
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("crushing: what a layer dissipates is the pressure times its volume, and the energy balance closes") {
  constexpr double speed = 2;
  Simulation simulation(pressed(at_speeds({0, (gap + 1.02 * spacing) / speed}, {-speed, -speed})));
  fixtures::run(simulation);
  // of the next layer, as the force; the ends of the depth, of which 1e-3 is left, have no share
  const double next = 0.02 * spacing, expected = pressure * face * (spacing + 3 * next * next / spacing);
  CHECK(fixtures::value(simulation, "total.contact_dissipation [J]") == relative(expected, 2e-3));
  CHECK(fixtures::value(simulation, "box.crushing_dissipation [J]") == relative(expected, 2e-3));
  // the elastic energy of the bonds of crushed particles is not accounted for: they were at no load, but for vibrations
  CHECK(std::fabs(fixtures::value(simulation, "total.energy_balance_error [J]")) < 1e-3 * expected);
}

TEST_CASE("crushing: a box that withdraws and returns meets what is left") {
  constexpr double speed = 2, half = 0.25 * spacing;
  // down by gap + half, up by half, down to a depth of 0.9 spacings
  const double down = (gap + half) / speed, up = half / speed, again = 0.9 * spacing / speed;
  constexpr double turn = 1e-7;  // [s]
  Simulation simulation(
      pressed(at_speeds({0, down, down + turn, down + up, down + up + turn, down + up + again}, {-speed, -speed, speed, speed, -speed, -speed})));
  double while_away = 0, largest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    const double time = simulation.clock().time(), force = fixtures::value(simulation, "box.force_z [N]");
    const double depth = speed * (time - down - 2 * up) + half;  // on the second way down
    if (time > down + 2e-5 && depth < 0.9 * half) while_away = fixtures::larger(while_away, std::fabs(force));
    largest = fixtures::larger(largest, force);
  }
  CHECK(while_away < 0.01 * pressure * face);
  CHECK(largest == relative(1.5 * pressure * face, 0.02));
  for (const std::uint32_t slot : simulation.bodies()[0].particles.slot_of()) {
    const Particles& particles = simulation.bodies()[0].particles;
    const bool is_top = particles.reference(slot).z > 1.2 * spacing;
    CHECK(particles.crushed.depth(slot) == fixtures::absolute(is_top ? 0.9 * spacing : 0, 2e-3 * spacing, "m"));
    // what is left lies at the rear side, which faces the fixed layer
    CHECK(particles.crushed.offset(slot).z == fixtures::absolute(-particles.crushed.depth(slot) / 2, 1e-9 * spacing, "m"));
  }
}

TEST_CASE("crushing: a particle that is crushed has no bonds, and contact with the impactor alone") {
  constexpr double speed = 2;
  Setup setup = pressed(at_speeds({0, (gap + 1.3 * spacing) / speed}, {-speed, -speed}));
  setup.contact.fragments.law = Choice{fragment_law_words, static_cast<int>(FragmentLaw::repulsive)};
  Simulation simulation(setup);
  fixtures::run(simulation);
  const Body& body = simulation.bodies()[0];
  int crushed = 0;
  for (const std::uint32_t slot : body.particles.slot_of()) {
    const bool is_top = body.particles.reference(slot).z > 1.2 * spacing;
    CHECK(body.particles.crushed.is_crushed(slot) == is_top);
    CHECK((body.family.damage(slot) == 1) == is_top);
    if (!is_top) continue;
    ++crushed;
    // its ball is pushed ahead of the face, 0.3 spacings into the layer below
    CHECK(body.particles.position.at(slot).z + body.particles.crushed.offset(slot).z ==
          fixtures::absolute(across * spacing / 2 - 1.3 * spacing - 5e-4 * spacing, 2e-3 * spacing, "m"));
    CHECK(body.particles.velocity.at(slot).z == relative(-speed, 0.01));
  }
  CHECK(crushed == across * across);
  CHECK(simulation.fragments()->contacts() == 0);
  std::size_t ends = 0, without_reverse = 0;
  for (const std::uint32_t slot : body.particles.slot_of())
    body.family.for_each_bond(slot, [&](const FamilyBond& bond) {
      bool has_reverse = false;
      body.family.for_each_bond(bond.j, [&](const FamilyBond& back) { has_reverse = has_reverse || back.j == slot; });
      ++ends, without_reverse += has_reverse ? 0 : 1;
    });
  CHECK(without_reverse == 0);
  CHECK(body.internal.broken_bonds() == body.family.initial_bonds() - ends / 2);
}

TEST_CASE("crushing: a free ball and a free block exchange momentum to rounding, and the force of a particle is at most the pressure on its largest section") {
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
  const auto angular_momentum = [&] {
    Vec3d sum = simulation.impactors()[0].body().angular_momentum({});
    const Particles& particles = simulation.bodies()[0].particles;
    for (const std::uint32_t slot : particles.slot_of()) sum += particles.mass(slot) * cross(particles.position.at(slot), particles.velocity.at(slot));
    return sum;
  };
  const std::array<double, 2> before{momentum("x"), momentum("z")};
  const Vec3d turning = angular_momentum();
  double largest = 0;
  std::size_t contacts = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    for (const ContactImpulse& one : simulation.impactors()[0].last_step().contact_impulses) {
      const double force = dot(one.impulse, -1.0 * one.contact.normal) / simulation.clock().dt;
      if (one.contact.radius > 0.01 * radius) largest = fixtures::larger(largest, force), ++contacts;
    }
  }
  CHECK(contacts > 1000);
  CHECK(largest <= 1.5 * pressure * spacing * spacing * (1 + 1e-9));
  CHECK(largest > 0.5 * pressure * spacing * spacing);
  CHECK(simulation.impactors()[0].unconverged_steps() == 0);
  CHECK(std::fabs(momentum("x") - before[0]) < 1e-12 * std::fabs(before[1]));  // thousands of roundings
  CHECK(std::fabs(momentum("z") - before[1]) < 1e-12 * std::fabs(before[1]));
  CHECK(fixtures::value(simulation, "box.velocity_z [m/s]") > -2.9);
  // impulses act at the centres of particles: at those of the balls that are left, it would change by 8e-4
  const double turned = norm(angular_momentum() - turning) / (radius * std::fabs(before[1]));
  CHECK(turned < 1e-7);
}

TEST_CASE("crushing: in a concave corner the force on a particle does not exceed the pressure on its largest section, and no wall is passed") {
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
      largest = fixtures::larger(largest, norm(one.impulse) / simulation.clock().dt);
  }
  CHECK(simulation.impactors()[0].unresolved(0).count == 0);
  Particles particles = simulation.bodies()[0].particles;
  CHECK(simulation.impactors()[0].initial_overlap(0, ContactParticles(particles, setup.contact.impactors, {}, 0)).empty());
  CHECK(largest > 0.5 * pressure * spacing * spacing);
  CHECK(largest < 1.5 * 1.01 * pressure * spacing * spacing);
}

TEST_CASE("crushing: particles of an edge that two impactors crush at once stay outside both, and dissipate the pressure times their volume") {
  constexpr double speed = 2;
  const double edge = across * spacing, end = (gap + 1.5 * spacing) / speed;
  Setup setup = pressed(at_speeds({0, end}, {-speed, -speed}));
  setup.bodies[0].particle_sets = {{.name = "base", .shape = BoxSolid{{0.5 * edge, edge, 0.5 * edge}}, .position = {-0.25 * edge, 0, -0.25 * edge}}};
  ImpactorSetup beside = setup.impactors[0];
  beside.name = "beside";
  // the two overlap beyond the edge of the block; impactors have no contact with one another
  beside.surface = BoxSurface{.size = {edge, 3 * edge, 3 * edge}, .edge_length = edge};
  beside.position = {edge + gap, 0, 0};
  beside.motion = {};
  beside.motion.x = at_speeds({0, end}, {-speed, -speed});
  setup.impactors.push_back(beside);
  Simulation simulation(setup);
  fixtures::run(simulation);
  for (const Impactor& impactor : simulation.impactors()) {
    CHECK(impactor.unresolved(0).count == 0);
    Particles particles = simulation.bodies()[0].particles;
    CHECK(impactor.initial_overlap(0, ContactParticles(particles, setup.contact.impactors, {}, 0)).empty());
  }
  // Across y, 4 + 4 - 1 cells are crushed wholly, and the 2 + 2 of the next layer that meet one wall by half. The cell in its corner meets both, and is crushed
  // by more than half, at most wholly.
  const double of_row = pressure * across * spacing * spacing * spacing;
  const double dissipated = fixtures::value(simulation, "box.crushing_dissipation [J]") + fixtures::value(simulation, "beside.crushing_dissipation [J]");
  CHECK(fixtures::count_crushed(simulation.bodies()[0].particles) == 7 * across);
  CHECK(dissipated > 9.5 * of_row);
  CHECK(dissipated < 10 * of_row);
  CHECK(std::fabs(fixtures::value(simulation, "total.energy_balance_error [J]")) < 5e-3 * dissipated);
}

TEST_CASE("crushing: a point cloud on the same points is crushed as the lattice") {
  constexpr double speed = 2;
  const auto dissipated = [&](const Setup& setup) {
    Simulation simulation(setup);
    fixtures::run(simulation);
    CHECK(fixtures::count_crushed(simulation.bodies()[0].particles) == simulation.bodies()[0].particles.size() / across);
    return fixtures::value(simulation, "box.crushing_dissipation [J]");
  };
  const Setup setup = pressed(at_speeds({0, (gap + 1.01 * spacing) / speed}, {-speed, -speed}));
  const double volume = face * spacing;
  CHECK(dissipated(setup) == relative(pressure * volume, 2e-3));
  Setup of_cloud = setup;
  BodySetup& cloud = of_cloud.bodies[0];
  const Particles lattice = make_particles(cloud);
  PointsShape points;
  for (const std::uint32_t slot : lattice.slot_of()) points.points.push_back(lattice.reference(slot)), points.volumes.push_back(lattice.volume(slot));
  points.file = "block.csv";
  cloud.shape = points, cloud.spacing.reset();
  CHECK(dissipated(of_cloud) == relative(dissipated(setup), 1e-6));
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

TEST_CASE("crushing: a particle is never pushed more than by rigid contact, nor crushed beyond its thickness") {
  for (const double push : {0.0, 0.3, 5.0, 1e3, 1e5})
    for (const double depth : {0.0, 4e-4, 1e-3, 1.9e-3})
      for (const double largest : {0.0, 1.0, 1e6, 1e10, 1.5e10, 1e11}) {
        const double thickness = 2e-3, left = thickness - depth, mass = 2e-5, dt = 1e-6;
        const fccda::Crushing material{largest, thickness, depth, left};
        const fccda::Crushed found = fccda::crushed(material, push, mass, dt);
        CHECK(found.push <= push);
        CHECK(found.push >= 0);
        CHECK(found.depth <= left);
        // momentum and displacement agree: what is not pushed is crushed
        CHECK(found.depth == fixtures::absolute((push - found.push) * dt, 1e-12, "m"));
        const double force = mass * found.push / dt, tolerance = 1e-9 * mass * push / dt;
        if (found.depth > 0 && found.depth < left) CHECK(force == fixtures::absolute(material.force(depth + found.depth), tolerance, "N"));
        if (found.depth == 0) CHECK(force <= material.force(depth) + tolerance);  // contact is rigid where it needs less
      }
}
