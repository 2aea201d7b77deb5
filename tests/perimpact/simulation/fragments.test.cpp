// Whole runs with contact between fragments: bodies that collide, break and rub.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <type_traits>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/snapshot.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/simulation/short_range_of.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

using fixtures::run;
using fixtures::value;

namespace {

BodySetup block(const std::string& name, const Vec3d& size, const Vec3d& position, const Vec3d& velocity, fixtures::BodyOptions options = {}) {
  options.size = size;
  BodySetup setup = fixtures::body_setup(options);
  setup.name = name, setup.position = position, setup.velocity = velocity;
  return setup;
}

Setup with_contact(std::vector<BodySetup> bodies, double end) {
  Setup setup;
  setup.time.end = end;
  setup.bodies = std::move(bodies);
  setup.contact.fragments.law.index = static_cast<int>(FragmentLaw::repulsive);
  return setup;
}

/// Two bars end to end that fly at one another, apart by a hundredth of a spacing.
Setup two_bars(Plane plane, double speed, double end) {
  const Vec3d size = plane == Plane::none ? Vec3d{0.024, 0.004, 0.004} : Vec3d{0.024, 0.004, 0.002};
  return with_contact(
      {block("left", size, {-0.012005, 0, 0}, {speed, 0, 0}, {.plane = plane}), block("right", size, {0.012005, 0, 0}, {-speed, 0, 0}, {.plane = plane})}, end);
}

/// Two brittle blocks, one of another material and spacing, which shatter one another askew.
Setup shattering() {
  fixtures::BodyOptions brittle{.critical_stretch = 1e-3}, other{.spacing = 0.00125, .poissons_ratio = 0.3, .critical_stretch = 2e-3};
  Setup setup = with_contact(
      {block("block", {0.010, 0.008, 0.006}, {}, {}, brittle), block("bullet", {0.005, 0.005, 0.005}, {0.0085, 0.002, 0.001}, {-600, 0, 20}, other)}, 1.5e-5);
  setup.contact.fragments.friction = 0.2;
  setup.contact.fragments.restitution = 0.8;
  return setup;
}

/// Breaks all bonds of a body, as the bond pass would.
void break_all(Simulation& simulation, const std::string& body) {
  simulation.visit_state([&](const std::string& name, auto&& values) {
    using Values = std::remove_cvref_t<decltype(values)>;
    if constexpr (std::is_base_of_v<std::span<std::uint8_t>, Values>) {
      if (name == body + ".bonds") std::fill(values.begin(), values.end(), std::uint8_t{0});
    } else if constexpr (std::is_base_of_v<std::span<std::uint32_t>, Values>) {
      if (name == body + ".broken_ends_of_eight")
        for (std::uint32_t& ends : values) ++ends;
    }
  });
}

/// The shortest distance of two particles without a bond, in spacings; |X_j - X_i| where that is shorter.
double nearest(const Body& body) {
  double least = 1e9;
  const Particles& p = body.particles;
  for (const std::uint32_t i : p.slot_of())
    for (const std::uint32_t j : p.slot_of())
      if (i < j) least = std::min(least, norm(p.position.at(j) - p.position.at(i)) / p.spacing());
  return least;
}

}  // namespace

TEST_CASE("fragments: two equal bars in head-on impact exchange their velocities, conserve momentum and the energy to one per cent, in 3-D and 2-D") {
  for (const Plane plane : {Plane::none, Plane::stress}) {
    CAPTURE(static_cast<int>(plane));
    Setup setup = two_bars(plane, 10, 30e-6);  // the wave needs 10 µs to the far end and back
    Simulation simulation(setup);
    CHECK(simulation.warnings().empty());
    const double energy = value(simulation, "total.energy [J]"), mass = simulation.bodies()[0].particles.total_mass();
    double most = 0;
    while (!simulation.clock().is_finished()) {
      simulation.step();
      most = fixtures::larger(most, simulation.fragments()->energy());
    }
    CHECK(most > 0.01 * energy);                                // contact occurred
    CHECK(value(simulation, "total.contact_energy [J]") == 0);  // and have parted
    CHECK(value(simulation, "total.energy [J]") == fixtures::relative(energy, 0.01));
    CHECK(std::fabs(value(simulation, "total.momentum_x [kg m/s]")) <= 1e-12 * mass * 10);
    // a wave without dispersion would turn all of it round; the lattice and the bars' thickness keep a little as vibration
    CHECK(simulation.bodies()[0].motion().momentum.x / mass == fixtures::relative(-10, 0.05));
    CHECK(simulation.bodies()[1].motion().momentum.x / mass == fixtures::relative(10, 0.05));
  }
}

TEST_CASE("fragments: without contact the same bars pass through one another, and history has no columns of it") {
  Setup setup = two_bars(Plane::none, 10, 30e-6);
  setup.contact.fragments.law.index = static_cast<int>(FragmentLaw::none);
  Simulation simulation(setup);
  run(simulation);
  CHECK(simulation.bodies()[0].motion().momentum.x == fixtures::relative(simulation.bodies()[0].particles.total_mass() * 10, 1e-12));
  for (const Column& column : simulation.monitors().columns()) CHECK(column.name.find("contact_energy") == std::string::npos);
}

TEST_CASE(
    "fragments: blocks that shatter one another end in the same state to the last bit on one, two and four threads, and whenever the pairs are looked for") {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4})
    for (const bool forgets : {false, true}) {
      if (threads == 4 && !forgets) continue;
      const fixtures::Threads with_several(threads);
      Simulation simulation(shattering());
      std::mt19937_64 random(static_cast<std::uint64_t>(threads));
      std::size_t most = 0;
      while (!simulation.clock().is_finished()) {
        if (forgets && random() % 3 == 0) simulation.forget_near_pairs();
        simulation.step();
        most = fixtures::larger(most, simulation.fragments()->contacts());
      }
      CHECK(value(simulation, "block.broken_bonds [-]") > 1000);
      CHECK(most > 30);
      CHECK(simulation.fragments()->friction_dissipation() > 0);
      hashes.push_back(simulation.state_hash());
    }
  for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
}

TEST_CASE("fragments: the dissipation by friction and dashpots is the energy loss of colliding rubble") {
  // no bonds: only the springs store energy, and the works are those of the scheme, so only its ripple of (ω dt)² is left
  Setup setup = with_contact(
      {block("left", {0.006, 0.006, 0.006}, {-0.0035, 0.0004, 0}, {40, 3, 0}), block("right", {0.006, 0.006, 0.006}, {0.0035, 0, 0.0003}, {-40, 0, 5})}, 3e-5);
  setup.contact.fragments.friction = 0.3;
  setup.contact.fragments.restitution = 0.6;
  Simulation simulation(setup);
  break_all(simulation, "left"), break_all(simulation, "right");
  const double first = value(simulation, "total.energy [J]");
  double furthest = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    const ShortRange& contact = *simulation.fragments();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    const double left = value(simulation, "total.energy [J]") + contact.friction_dissipation() + contact.dashpot_dissipation();
    furthest = fixtures::larger(furthest, std::fabs(left / first - 1));
  }
  CHECK(furthest <= 0.02);
  CHECK(simulation.fragments()->friction_dissipation() > 0.01 * first);
  CHECK(simulation.fragments()->dashpot_dissipation() > 0.05 * first);
}

TEST_CASE("fragments: a slider under pressure is braked by µ times the pressure, and comes to rest") {
  // particles right above one another, and a displacement so short that they stay so; the slab below is constrained
  const double spacing = 0.001, acceleration = 3e4, friction = 0.3, speed = 0.3;
  Setup setup = with_contact({block("slab", {0.004, 0.004, 0.003}, {0, 0, -0.0015}, {}), block("slider", {0.004, 0.004, 0.002}, {0, 0, 0.001}, {})}, 1);
  setup.contact.fragments.friction = friction;
  std::vector<Body> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(make_body(body));
  Particles &slab = bodies[0].particles, &slider = bodies[1].particles;
  const auto contacts = contacting_bodies(setup, bodies);
  ShortRange contact = *short_range_of(setup, bodies);
  const double dt = 0.3 * silling_askari_step(bodies[1], contact.bounds(contacts)[1]);
  std::vector<double> travel(std::max(travel_blocks(slab), travel_blocks(slider)));
  const auto step = [&](double damping) {
    advance(slider, dt, std::span(travel).first(travel_blocks(slider)));
    bodies[1].internal.evaluate(slider, bodies[1].family);
    contact.add_forces(contacts, dt);
    for (const std::uint32_t slot : slider.slot_of()) {
      const double density = slider.density();
      slider.force_density.set(slot, slider.force_density.at(slot) - Vec3d{0, 0, density * acceleration} - damping * density * slider.velocity.at(slot));
    }
  };
  const auto mean_speed = [&] { return bodies[1].motion().momentum.x / slider.total_mass(); };
  for (int settling = 0; settling < 4000; ++settling) step(2e5);  // near critical for the layer on its contact
  REQUIRE(std::fabs(bodies[1].motion().momentum.z / slider.total_mass()) < 0.01 * speed);
  REQUIRE(contact.contacts() >= 64);  // all pairs within √3 of a spacing along the face of which an end is pressed: corners begin later
  for (const std::uint32_t slot : slider.slot_of()) slider.velocity.set(slot, slider.velocity.at(slot) + Vec3d{speed, 0, 0});
  const double brake = friction * acceleration;
  double time = 0, way = 0;
  while (time < 0.8 * speed / brake) step(0), time += dt, way += mean_speed() * dt;
  CHECK(way < 0.01 * spacing);
  CHECK(speed - mean_speed() == fixtures::relative(brake * time, 0.05));  // tilted by a hundredth, the normals push back by a thirtieth of it
  while (time < 3 * speed / brake) step(0), time += dt;
  CHECK(std::fabs(mean_speed()) < 0.05 * speed);
}

namespace {

/// Turns a body about an axis through a point: a rigid motion, which strains nothing.
void turn(Simulation& simulation, const std::string& body, const Vec3d& centre, std::size_t axis, double angle) {
  std::vector<std::span<double>> x;
  simulation.visit_state([&](const std::string& name, auto&& values) {
    if constexpr (std::is_base_of_v<std::span<double>, std::remove_cvref_t<decltype(values)>>)
      if (name.starts_with(body + ".position_")) x.push_back(values);
  });
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (std::size_t slot = 0; slot < x[0].size(); ++slot) {
    const double u = x[a][slot] - centre[a], w = x[b][slot] - centre[b];
    x[a][slot] = centre[a] + std::cos(angle) * u - std::sin(angle) * w;
    x[b][slot] = centre[b] + std::sin(angle) * u + std::cos(angle) * w;
  }
}

BodySetup soft_block(const std::string& name, const Vec3d& size, const Vec3d& position, const Vec3d& velocity) {
  BodySetup setup = block(name, size, position, velocity, {.spacing = 0.05});
  BondBasedSetup material;
  material.youngs_modulus = 1e9, material.density = 1000;
  setup.material = material;
  return setup;
}

Vec3d mean_velocity(const Simulation& simulation, std::size_t body) {
  return simulation.bodies()[body].motion().momentum / simulation.bodies()[body].particles.total_mass();
}

struct Rebound {
  double restitution, sideways;  // over the speed of approach
};

/// Two cubes of 8³ particles that meet face to face at ±speed, the second moved sideways by parts of a spacing and turned about the normal.
Rebound rebound(double speed, double along_y, double along_z, double angle) {
  const double spacing = 0.05;
  const Vec3d set_initial_state{0.23, along_y * spacing, along_z * spacing};
  Setup setup =
      with_contact({soft_block("a", {0.4, 0.4, 0.4}, {-0.23, 0, 0}, {speed, 0, 0}), soft_block("b", {0.4, 0.4, 0.4}, set_initial_state, {-speed, 0, 0})},
                   0.03 / speed + 4e-3);
  Simulation simulation(setup);
  turn(simulation, "b", set_initial_state, 0, angle);
  run(simulation);
  CHECK(value(simulation, "total.contact_energy [J]") == 0);  // they have parted
  const Vec3d a = mean_velocity(simulation, 0), b = mean_velocity(simulation, 1);
  return {(b.x - a.x) / (2 * speed), std::hypot(a.y, a.z) / speed};
}

}  // namespace

TEST_CASE("fragments: face-to-face contact of blocks depends neither on the phase nor on the rotation of their lattices") {
  for (const double speed : {1.0, 5.0}) {
    const Rebound plain = rebound(speed, 0, 0, 0);
    CAPTURE(speed);
    CHECK(plain.restitution > 0.5);
    for (const auto& [y, z, angle] : {std::array{0.5, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.25, 0.1, 0.0}, {0.0, 0.0, 0.3}, {0.3, 0.1, 0.7854}}) {
      CAPTURE(y);
      CAPTURE(angle);
      const Rebound other = rebound(speed, y, z, angle);
      CHECK(other.restitution == fixtures::relative(plain.restitution, 0.05));  // what is asked of contact
      CHECK(other.sideways <= 0.02);
    }
  }
}

TEST_CASE("fragments: a block that slides on another without friction keeps its speed, for any angle of its lattice") {
  for (const double angle : {0.0, 0.35}) {
    CAPTURE(angle);
    const Vec3d start{-0.4, 0.01, 0.1};
    Setup setup = with_contact({soft_block("floor", {1.6, 0.6, 0.2}, {0, 0, -0.1}, {}), soft_block("slider", {0.3, 0.3, 0.2}, start, {4, 0, 0})}, 0.2);
    BodyForceSetup weight;
    weight.force_density = {0, 0, -1e4};
    setup.bodies[1].boundary_conditions.push_back({"weight", weight});
    SolidSetup bottom;
    bottom.name = "bottom", bottom.shape = BoxSolid{{2, 2, 0.11}}, bottom.position = {0, 0, -0.1};
    setup.bodies[0].particle_sets = {bottom};
    setup.bodies[0].boundary_conditions.push_back({"bottom", FixedSetup{"bottom", {}}});
    Simulation simulation(setup);
    turn(simulation, "slider", start, 2, angle);
    double pushed = 0;
    while (!simulation.clock().is_finished()) {
      simulation.step();
      pushed += simulation.fragments()->contacts() > 0;
    }
    CHECK(pushed > 0.2 * static_cast<double>(simulation.clock().steps));   // it does not fly
    CHECK(mean_velocity(simulation, 1).x == fixtures::relative(4, 0.01));  // over 16 spacings
    CHECK(std::fabs(mean_velocity(simulation, 1).y) <= 0.04);
  }
}

TEST_CASE("fragments: friction and dashpots dissipate in every step of confined crushing, and the energy balance closes") {
  // a heavy sphere into a block in a rigid mould: rubble is compressed and slides against constrained particles
  fixtures::BodyOptions ice{.spacing = 0.1, .model = fixtures::Model::bond_based};
  BodySetup body = block("ice", {1.2, 1.2, 0.6}, {0, 0, -0.3}, {}, ice);
  BondBasedSetup material;
  material.youngs_modulus = 1.8e9, material.density = 900, material.critical_stretch = 3.2e-4;
  body.material = material;
  const auto mould = [&](const std::string& name, const Vec3d& size, const Vec3d& set_initial_state) {
    SolidSetup region;
    region.name = name, region.shape = BoxSolid{size}, region.position = set_initial_state;
    body.particle_sets.push_back(region);
    body.boundary_conditions.push_back({name, FixedSetup{name, {}}});
  };
  mould("bottom", {2, 2, 0.21}, {0, 0, -0.2});
  mould("west", {0.21, 2, 0.39}, {-0.5, 0, 0.1}), mould("east", {0.21, 2, 0.39}, {0.5, 0, 0.1});
  mould("south", {0.79, 0.21, 0.39}, {0, -0.5, 0.1}), mould("north", {0.79, 0.21, 0.39}, {0, 0.5, 0.1});
  Setup setup = with_contact({body}, 0.02);
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.9, .edge_length = 0.1};
  ball.mass = 1000;
  ball.position = {0, 0, 0.450001};
  ball.velocity = {0, 0, -5};
  setup.impactors = {ball};
  setup.contact.fragments.friction = 0.3;
  setup.contact.fragments.restitution = 0.7;
  Simulation simulation(setup);
  double friction = 0, restitution = 0;
  bool falls = false;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    const ShortRange& contact = *simulation.fragments();
    falls = falls || contact.friction_dissipation() < friction || contact.dashpot_dissipation() < restitution;
    friction = contact.friction_dissipation(), restitution = contact.dashpot_dissipation();
  }
  CHECK(!falls);
  const double work = std::fabs(value(simulation, "ball.contact_work [J]"));
  CHECK(friction > 0.005 * work);
  CHECK(std::fabs(value(simulation, "total.energy_balance_error [J]")) <= 0.005 * work);  // what is asked of contact
}

TEST_CASE("fragments: the fragments of a block under impact separate, and conserve their total momentum") {
  fixtures::BodyOptions brittle{.critical_stretch = 1e-3};
  Setup setup = with_contact({block("block", {0.010, 0.008, 0.005}, {}, {}, brittle)}, 2e-5);
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.006, .edge_length = 0.0007};
  ball.mass = 2e-3;
  ball.position = {0, 0.0071, 0};
  ball.velocity = {0, -200, 0};
  ball.free_dofs = {"x", "y", "z"};
  setup.impactors = {ball};
  double apart[2];
  for (const bool touches : {false, true}) {
    setup.contact.fragments.law.index = touches ? 1 : 0;
    Simulation simulation(setup);
    const double before = value(simulation, "total.momentum_y [kg m/s]");
    run(simulation);
    CHECK(value(simulation, "block.broken_bonds [-]") > 0.1 * static_cast<double>(simulation.bodies()[0].family.initial_bonds()));
    CHECK(value(simulation, "total.momentum_y [kg m/s]") == fixtures::relative(before, 1e-12));
    apart[touches] = nearest(simulation.bodies()[0]);
  }
  CHECK(apart[0] < 0.5 * apart[1]);
  CHECK(apart[1] > 0.4);  // of a spacing; contact begins at 0.9 and is compliant
}

TEST_CASE("fragments: a restart is bitwise exact, also in the works") {
  const Setup setup = shattering();
  Simulation whole(setup);
  std::optional<Simulation> resumed(std::in_place, setup);
  while (!whole.clock().is_finished()) {
    if (whole.clock().step % 7 == 3) {
      const ::fixtures::Snapshot snapshot(*resumed);
      resumed.emplace(setup);
      snapshot.give(*resumed);
    }
    whole.step(), resumed->step();
    REQUIRE(resumed->state_hash() == whole.state_hash());
    REQUIRE(resumed->fragments()->friction_dissipation() == whole.fragments()->friction_dissipation());
  }
  CHECK(whole.fragments()->friction_dissipation() > 0);
}

TEST_CASE("fragments: 2-D bodies have contact within their plane only") {
  std::string key;
  Setup mixed = two_bars(Plane::none, 10, 1e-6);
  mixed.bodies[1].plane.index = static_cast<int>(Plane::stress);
  CHECK(fixtures::complaint(mixed, key) ==
        "body right is plane and body left is not, but contact is supported between bodies of the same dimension only; set law: none, or give both the same "
        "plane.");
  CHECK(key == "contact.fragments.law");
  Setup apart = two_bars(Plane::stress, 10, 1e-6);
  apart.bodies[1].position.z = 0.001;
  CHECK(fixtures::complaint(apart, key) ==
        "the plane bodies left and right lie at z = 0 m and 0.001 m, but contact is supported within one plane only; give them the same z, or set law: none.");
}

TEST_CASE("fragments: bodies initially closer than the contact distance yield a warning") {
  Setup setup = two_bars(Plane::none, 0, 1e-6);
  setup.bodies[1].position.x = 0.0116;
  const std::vector<std::string> warnings = Simulation(setup).warnings();
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find(" pairs of particles are initially closer than their contact distance, and ") != std::string::npos);
}

TEST_CASE("stable step: contact of fragments shortens it, and dashpots more so") {
  Setup setup = two_bars(Plane::none, 10, 30e-6);
  const auto step = [&] { return Simulation(setup).stability().estimate; };
  const double with = step();
  setup.contact.fragments.restitution = 0.5;
  const double damped = step();
  setup.contact.fragments.law.index = static_cast<int>(FragmentLaw::none);
  const double without = step();
  // 1/dt² is a sum: what contact adds is 12 · 15 c V/(2 ρ δ)
  const Body body = make_body(setup.bodies[0]);
  const double k = contacting_bodies(setup, std::span(const_cast<Body*>(&body), 1)).front().stiffness, volume = 1e-9;
  CHECK(1 / (with * with) == fixtures::relative(1 / (without * without) + 12 * k * volume / (2 * fixtures::density), 1e-9));
  CHECK(damped < with);
}
