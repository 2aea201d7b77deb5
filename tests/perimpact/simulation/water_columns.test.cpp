// Columns of a floating body: the water that they entrain, tops that stay dry, and the righting moment of a box, against formulas.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/boundary_conditions/floating/floating.hpp"
#include "perimpact/boundary_conditions/floating/floating_sheet.hpp"
#include "perimpact/floating_boxes.hpp"
#include "perimpact/resuming.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::calm;
using fixtures::complaint;
using fixtures::gravity;
using fixtures::ice;
using fixtures::sea;
using fixtures::value;

namespace {

constexpr double height = 2, foundation = sea * gravity;
constexpr double draught = height * ice / sea, afloat = height / 2 - draught;  // [m] z of the middle of a box whose water is at 0
constexpr double pi = std::numbers::pi;

Setup box(const Vec3d& size, double z, const FloatingSetup& water, double end, double youngs_modulus = 2e6, double spacing = 0.5) {
  return fixtures::floating_box(size, z, water, end, {.youngs_modulus = youngs_modulus, .spacing = spacing});
}

Setup block(double z, const FloatingSetup& water, double end, double spacing = 0.5) { return box({height, height, height}, z, water, end, 2e6, spacing); }

/// [s] of one oscillation of the mean of `weight(X)` times the vertical velocity, from its upward crossings of zero.
template <class Weight>
double period(Simulation& simulation, const Weight& weight) {
  const Particles& particles = simulation.bodies()[0].particles;
  std::vector<double> times;
  double before = 0;
  while (!simulation.clock().is_finished()) {
    simulation.step();
    double now = 0;
    for (const std::uint32_t slot : particles.slot_of()) now += weight(particles.reference(slot)) * particles.velocity.at(slot).z;
    if (before < 0 && now >= 0) times.push_back(simulation.clock().time() - simulation.clock().dt * now / (now - before));
    before = now;
  }
  REQUIRE(times.size() >= 2);
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

/// Hydrostatics of a body of the fixtures whose particles lie where `place` puts them.
struct Afloat {
  Body body;
  Floating water;

  Afloat(const Vec3d& size, double spacing, Water its) : body(fixtures::body({.size = size, .spacing = spacing})), water(body.particles, slots(), its, 0) {}
  std::vector<std::uint32_t> slots() const { return {body.particles.slot_of().begin(), body.particles.slot_of().end()}; }
  double force() {
    body.particles.force_density = VectorArray(body.particles.slots(), 0);
    return water.static_hydrostatics(body.particles).force.z;
  }
};

/// Forces that accelerate all particles alike.
void push(Particles& particles) {
  for (const std::uint32_t slot : particles.slot_of()) particles.force_density.set(slot, {0, 0, 1});
}

Water still(double level) { return {.level = level, .density = sea, .gravity = gravity, .drag = 0, .added_mass = 0, .damping = 0}; }

}  // namespace

TEST_CASE("water columns: the entrained mass of a column is the depth times its area for any number of layers, and none in air") {
  for (const double layer : {2.0, 1.0, 0.5, 0.25}) {
    for (const double level : {-1.2, -0.5, 0.9}) {
      Water water = still(level);
      water.entrained_depth = 4.5;
      Afloat floe({2, 2, 2}, layer, water);
      Particles& particles = floe.body.particles;
      push(particles);
      floe.water.resist(particles, 1e-3);
      double entrained = 0;
      for (const std::uint32_t slot : particles.slot_of())
        entrained += (1 / particles.force_density.at(slot).z - 1) * particles.density() * particles.volume(slot);
      const double wet = std::clamp((level + 1) / layer, 0.0, 1.0);  // of the lowest layer
      if (wet == 0)
        CHECK(entrained == fixtures::absolute(0, 1e-6, "kg"));  // rounding of 64 t
      else
        CHECK(entrained == fixtures::relative(sea * 4.5 * 4 * wet, 1e-9));  // rounding of 64 t against some tonnes
    }
  }
}

TEST_CASE("water columns: a block heaves with the period of its mass and the water that it entrains, for any number of layers") {
  FloatingSetup water = calm();
  water.entrained_depth = 1.5;
  for (const double spacing : {1.0, 0.5}) {
    Simulation bobs(block(afloat + 0.05, water, 10, spacing));
    const double expected = 2 * pi * std::sqrt((ice * height + sea * 1.5) / foundation);
    // 1 %: the block's own springs, and a step of its period/1000
    CHECK(period(bobs, [](const Vec3d&) { return 1.0; }) == fixtures::relative(expected, 0.01));
  }
}

TEST_CASE("water columns: a standing wave of a strip is slower by the water of the depth 1/k, and by mass scaling of as much inertia") {
  constexpr double length = 20, span = length - 0.5, k = pi / span;  // between the outermost columns, which support it
  const auto frequency = [&](double depth, double mass_scaling) {
    FloatingSetup water = calm();
    water.entrained_depth = depth;
    Setup setup = box({length, 1, height}, afloat + 0.05, water, depth > 0 || mass_scaling > 1 ? 12 : 6, 2e7);
    BodySetup& strip = setup.bodies[0];
    strip.mass_scaling = mass_scaling;
    for (const double end : {-1.0, 1.0}) {
      const std::string name = end < 0 ? "left" : "right";
      strip.particle_sets.push_back({.name = name, .shape = BoxSolid{.size = {0.5, 4, 4}}, .position = {end * span / 2, 0, 0}});
      strip.boundary_conditions.push_back({name, FixedSetup{.particle_set = name, .directions = {"z"}}});
    }
    strip.boundary_conditions.push_back({"sides", FixedSetup{.directions = {"y"}}});
    Simulation simulation(setup);
    return 2 * pi / period(simulation, [&](const Vec3d& at) { return std::cos(k * at.x); });
  };
  const double rotation = ice * height * height * height / 12 * k * k;             // rotary inertia
  const double in_air = std::pow(frequency(0, 1), 2) * (ice * height + rotation);  // D k⁴ + ρ_w g, with the stiffness of these layers
  const double plate = 2e7 * height * height * height / (12 * (1 - 0.0625)) * std::pow(k, 4) + foundation;
  CHECK(in_air == fixtures::relative(plate, 0.15));  // four layers of two particles are a fifth softer than a plate
  CHECK(frequency(1 / k, 1) == fixtures::relative(std::sqrt(in_air / (ice * height + rotation + sea / k)), 0.01));  // motion along the strip entrains none
  const double scaling = 1 + sea / k / (ice * height);
  CHECK(frequency(0, scaling) == fixtures::relative(std::sqrt(in_air / (scaling * (ice * height + rotation))), 0.01));  // here it is slower as well
}

TEST_CASE("water columns: the characteristic length of two metres of ice of 1.8 GPa is 18.9 m") {
  // by hand: D = 1.8e9 8/(12 15/16) = 1.28e9 N m; 1.28e9/10055.25 = 127297; its fourth root
  CHECK(characteristic_length({1.8e9, 0.25}, 2, foundation) == fixtures::relative(18.889, 1e-4));
}

TEST_CASE("water columns: with a dry top the buoyancy of a column increases beyond its height, for any number of layers") {
  for (const double layer : {2.0, 1.0, 0.5, 0.25})
    for (const double level : {-0.3, 1.0, 1.2, 1.7}) {
      Water water = still(level);
      const double weight = fixtures::density * gravity * 8;
      CHECK(Afloat({2, 2, 2}, layer, water).force() == fixtures::relative(foundation * 4 * std::min(level + 1, 2.0) - weight, 1e-12));
      water.dry_top = 1;
      CHECK(Afloat({2, 2, 2}, layer, water).force() == fixtures::relative(foundation * 4 * (level + 1) - weight, 1e-12));
    }
}

TEST_CASE("water columns: an edge pressed below its freeboard deflects by 2 P λ/k with a dry top, and more without") {
  constexpr double youngs_modulus = 1.8e7, load = 17e3, spacing = 0.5, width = 2;  // [Pa], [N/m], [m]
  constexpr double stiffness = youngs_modulus * height * height * height / (12 * (1 - 0.0625));
  const double lambda = std::pow(foundation / (4 * stiffness), 0.25), length = 68;  // eight times 1/λ
  const auto deflection = [&](double dry_top) {
    FloatingSetup water = calm();
    water.dry_top = dry_top;
    Setup setup = box({length, width, height}, afloat, water, 1, youngs_modulus, spacing);
    setup.time.relax = RelaxSetup{.increments = 1, .tolerance = 1e-5};
    setup.output.history_interval.reset();
    BodySetup& strip = setup.bodies[0];
    strip.bending_calibration.index = static_cast<int>(ThinAxis::z);
    const double end = (length - spacing) / 2;
    strip.particle_sets = {{.name = "edge", .shape = BoxSolid{.size = {spacing, 4, 4}}, .position = {-end, 0, 0}},
                           {.name = "far", .shape = BoxSolid{.size = {spacing, 4, 4}}, .position = {end, 0, 0}}};
    strip.boundary_conditions.push_back({"sides", FixedSetup{.directions = {"y"}}});
    strip.boundary_conditions.push_back({"far", FixedSetup{.particle_set = "far", .directions = {"x"}}});
    strip.boundary_conditions.push_back({"load", BodyForceSetup{.particle_set = "edge", .force_density = {0, 0, -load / (spacing * height)}}});
    Simulation simulation(setup);
    fixtures::run(simulation);
    const Particles& particles = simulation.bodies()[0].particles;
    double sum = 0, count = 0;
    for (const std::uint32_t slot : particles.slot_of())
      if (particles.reference(slot).x < -end + 0.1) sum -= particles.displacement(slot).z, ++count;
    return sum / count;
  };
  // the load acts on the last column, a half spacing a from the edge: that of the edge and the moment -P a, at x = a (Hetényi 1946)
  const double a = lambda * spacing / 2, decay = std::exp(-a);
  const double expected = 2 * load * lambda / foundation * decay * (std::cos(a) - a * (std::cos(a) - std::sin(a)));
  REQUIRE(expected > 1.4 * (height - draught));
  CHECK(deflection(1) == fixtures::relative(expected, 0.02));  // the calibrated stiffness of four layers in narrow strips: -0.8 %, floating_strip.md
  CHECK(deflection(0) > 1.02 * expected);
}

TEST_CASE("water columns: what the water loses as it floods a top is an account of its own, and the work is that of the potential") {
  constexpr double speed = 1, end = 2, dry = 0.5;
  FloatingSetup water = calm();
  water.dry_top = dry;
  Setup setup = block(afloat, water, end);
  PrescribedSetup down;
  down.z.emplace().velocity = -speed;
  setup.bodies[0].boundary_conditions.push_back({"press", down});
  Simulation press(setup);
  fixtures::run(press);
  const double area = height * height, way = speed * press.clock().time(), deepest = draught + way;
  const double before = 0.5 * foundation * area * draught * draught, after = foundation * area * (height * deepest - 0.5 * height * height);
  const double loss = value(press, "ice.sea.flooding_dissipation [J]"), work = value(press, "ice.sea.weight_buoyancy_work [J]");
  CHECK(work + loss == fixtures::relative(before - after + ice * area * height * gravity * way, 1e-9));  // rounding of 50 particles and 300 steps
  // at the first step beyond that depth: at most a step deeper
  CHECK(loss >= 0.5 * foundation * area * dry * dry);
  CHECK(loss < 0.5 * foundation * area * std::pow(dry + speed * press.clock().dt, 2));
}

TEST_CASE("water columns: columns that have lost bonds are flooded, and the others stay dry") {
  FloatingSetup water = calm();
  water.dry_top = 1;
  constexpr double depth = 0.3;
  Setup setup = box({8, height, height}, -height / 2 - depth, water, 0.1);
  setup.bodies[0].cracks = {{"cut", {{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}}}};
  const Simulation cut(setup);
  const Body& body = cut.bodies()[0];
  double dry = 0, flooded = 0;
  for (const std::uint32_t slot : body.particles.slot_of())
    if (body.particles.reference(slot).z > -depth - 0.3) (body.family.damage(slot) > 0 ? flooded : dry) += 0.25;  // [m²] of the top layer
  CHECK(flooded >= 4);
  CHECK(dry >= 4);
  const double weight = ice * gravity * 8 * height * height;
  const double expected = foundation * (height * (dry + flooded) + depth * dry) - weight;
  CHECK(cut.boundary_conditions()[0].all()[0].account().force().z == fixtures::relative(expected, 1e-10));  // rounding of 256 particles
}

TEST_CASE("water columns: a particle entrains water in proportion to its intact bonds") {
  FloatingSetup water = calm();
  water.entrained_depth = 3;
  Setup setup = box({4, height, height}, afloat, water, 0.1);
  setup.bodies[0].cracks = {{"cut", {{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}}}};
  Simulation cut(setup);
  // the force densities are those after the water: the added mass is what the reaction of the water per acceleration says
  Floating& floating = std::get<Floating>(const_cast<NamedBoundaryCondition&>(cut.boundary_conditions()[0].all()[0]).boundary);
  Particles particles = cut.bodies()[0].particles;
  push(particles);
  floating.resist(particles, 1e-3);
  for (const std::uint32_t slot : particles.slot_of()) {
    const double share = 1 - cut.bodies()[0].family.damage(slot), added = (1 / particles.force_density.at(slot).z - 1) * ice;
    CHECK(added == fixtures::relative(sea * 3 * share / height, 1e-9));
  }
}

TEST_CASE("water columns: an impactor at constant velocity carries all of the net buoyancy, whatever water the block moves along") {
  constexpr double pace = 0.05, damping = 40, volume = height * height * height;  // [m/s] [1/s] [m³]
  FloatingSetup water = calm();
  water.level = 10, water.damping = damping;
  constexpr double step = 1e-3;  // [s] smaller than the stable one, since the first contact is sudden
  // [N] of a block under water; damping, implicit in the velocity, divides the force that contact opposes
  const double expected = ((sea - ice) * gravity * volume + ice * volume * damping * pace) / (1 + damping * step / 2);
  const auto force = [&](double entrained_depth, double added_mass) {
    water.entrained_depth = entrained_depth, water.added_mass = added_mass;
    Setup setup = block(0, water, 3);
    setup.bodies[0].velocity = {0, 0, -pace};
    setup.time.step = step;
    ImpactorSetup plate;
    plate.name = "plate";
    plate.surface = BoxSurface{.size = {4, 4, 1}, .edge_length = 1};
    plate.mass = 1000;
    plate.position = {0, 0, height / 2 + 0.5};
    plate.velocity = {0, 0, -pace};
    setup.impactors = {plate};
    Simulation pressed(setup);
    fixtures::run(pressed);
    CHECK(pressed.contacts() == 16);  // the top layer
    return value(pressed, "plate.force_z [N]");
  };
  // vibrations decay by e^(-40 s⁻¹ 3 s/2) without water, and with water of 6.8 times the mass of the block by e⁻⁷·⁷
  CHECK(force(0, 0) == fixtures::relative(expected, 0.002));
  CHECK(force(6, 0) == fixtures::relative(expected, 0.002));
  CHECK(force(0, 3) == fixtures::relative(expected, 0.002));
}

TEST_CASE("water columns: energy and momentum close through a splash with entrained water and a top that floods") {
  FloatingSetup water = calm();
  water.drag = 1, water.damping = 0.3, water.entrained_depth = 1.2, water.dry_top = 0.1;
  Setup setup = block(1.5, water, 3);
  setup.bodies[0].velocity = {0, 0, -2};
  Simulation splash(setup);
  const double momentum = value(splash, "total.momentum_z [kg m/s]");
  const auto [impulse, largest, off] = fixtures::run_in_water(splash);
  CHECK(value(splash, "ice.sea.flooding_dissipation [J]") > 0);  // it went that deep
  CHECK(off < 0.005 * largest);                                  // second order in the step but where the level passes the corners of S, or a top floods
  CHECK(value(splash, "total.momentum_z [kg m/s]") - momentum == fixtures::relative(impulse, 1e-9));  // rounding
}

TEST_CASE("water columns: a restart after every step is bitwise exact while tops flood") {
  FloatingSetup water = calm();
  water.entrained_depth = 1.2, water.dry_top = 0.1;
  Setup setup = block(afloat - 0.25, water, 0.25);
  setup.bodies[0].velocity = {0, 0, -2};
  Simulation whole(setup);
  fixtures::run(whole);
  CHECK(value(whole, "ice.sea.flooding_dissipation [J]") > 0);
  fixtures::expect_same_when_resumed_at_every_step(setup);
}

TEST_CASE("water columns: a particle set whose top is not that of the body has no dry top") {
  FloatingSetup water = calm();
  water.dry_top = 1, water.particle_set = "lower";
  Setup setup = block(-height / 2 - 0.3, water, 0.1);
  setup.bodies[0].particle_sets = {{.name = "lower", .shape = BoxSolid{.size = {4, 4, 1}}, .position = {0, 0, -0.5}}};
  const Simulation lower(setup);
  CHECK(lower.boundary_conditions()[0].all()[0].account().force().z == fixtures::relative((sea - ice) * gravity * 4, 1e-12));  // under water, as a whole
}

TEST_CASE("water columns: bodies without columns are refused an entrained depth and a dry top") {
  for (const bool is_dry : {false, true}) {
    FloatingSetup water = calm();
    (is_dry ? water.dry_top : water.entrained_depth) = 1;
    Setup setup = block(0, water, 0.1);
    PointsShape points;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5}) points.points.push_back({x, y, z}), points.volumes.push_back(1);
    setup.bodies[0].shape = points;
    setup.bodies[0].spacing.reset();
    CHECK(complaint(setup) == "bodies.ice.boundary_conditions.sea.floating: " + std::string(is_dry ? "dry_top" : "entrained_depth") +
                                  " belongs to the columns of a lattice, but the particles of body ice are those of a file; " +
                                  (is_dry ? "remove it." : "give added_mass."));
  }
}

TEST_CASE("water columns: a heeled box has the righting arm of naval hydrostatics") {
  constexpr double beam = 8, heel = 3 * pi / 180;
  constexpr double metacentric = beam * beam / (12 * draught) - (height - draught) / 2;                                  // GM = BM - BG
  const double arm = std::sin(heel) * (metacentric + 0.5 * beam * beam / (12 * draught) * std::pow(std::tan(heel), 2));  // wall-sided
  for (const double layer : {2.0, 1.0, 0.5, 0.25}) {
    Water water = still(0);
    water.density = fixtures::density * sea / ice;
    Afloat floe({beam, 2, height}, layer, water);
    fixtures::deform(floe.body, [](const Vec3d& at) {
      return Vec3d{at.x * std::cos(heel) + at.z * std::sin(heel), at.y, at.z * std::cos(heel) - at.x * std::sin(heel)};
    });
    water.level = *floating_level(floe.body.particles, floe.slots(), water);
    const double displaced = fixtures::density * beam * 2 * height / water.density;
    double moment = 0;
    for (const std::uint32_t slot : floe.slots()) {
      const Vec3d at = floe.body.particles.position.at(slot);
      moment += at.x * water.submerged(at.z, layer) * layer * layer * layer / displaced;
    }
    // a particle's own waterplane and the centre of its wet part are missing: (Δ²/T) (1/12 - S (1 - S)/2) of the metacentric height for one layer,
    // and at a finite heel steps of the waterline from particle to particle
    CHECK(moment == fixtures::relative(arm, layer > 1 ? 0.03 : 0.005));
  }
}
