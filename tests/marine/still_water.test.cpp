#include "marine/still_water.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "fccda/rigid_body/solid.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;

namespace {

constexpr FreeDegrees heave{{false, false, true, false, false, false}};
constexpr FreeDegrees roll{{false, false, false, true, false, false}};
constexpr FreeDegrees all_free{{true, true, true, true, true, true}};
constexpr StillWater sea{.level = 0.2, .density = 1025, .gravity = 9.81};

const Vec3d size{4, 2, 1};  // [m] of the box, along x, y, z

Surface make_box_surface() { return Surface(make_box({.size = size, .edge_length = 0.5})); }

/// A box of half the density of water, with its centre at the given height above the level.
RigidBody afloat_box(const Surface& box, double above, const FreeDegrees& degrees, const Quaternion& attitude = {}) {
  return RigidBody(solid_of_mass(box.report(), 0.5 * sea.density * size.x * size.y * size.z), Pose({0, 0, sea.level + above}, attitude), {}, {}, degrees);
}

Step step_from(long n, double dt) { return {static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, dt}; }

/// Times [s] at which `value()` passes 0 upward, with linear interpolation between steps.
template <class Value, class Advance>
std::vector<double> upward_crossings(double end, double dt, const Value& value, const Advance& advance) {
  std::vector<double> times;
  double before = value();
  for (long n = 0; n < std::lround(end / dt); ++n) {
    advance(step_from(n, dt));
    const double after = value();
    if (before < 0 && after >= 0) times.push_back((static_cast<double>(n) + before / (before - after)) * dt);
    before = after;
  }
  return times;
}

}  // namespace

TEST_CASE("still water: force and moment are the gradient of the potential, at any attitude") {
  const Surface box = make_box_surface();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> height(-0.8, 0.8);
  for (int trial = 0; trial < 50; ++trial) {
    const Quaternion attitude = Quaternion::from_rotation(3 * fixtures::random_direction(random));
    const RigidBodyProperties properties{.mass = 3000, .centre_of_mass = {0.3, -0.1, 0.2}, .inertia = Mat3::diagonal({1, 1, 1})};
    const Vec3d place{1, 2, height(random)};
    const RigidBody body(properties, Pose(place, attitude), {}, {}, all_free);
    const Hydrostatics now = hydrostatics(body, box, sea);
    const double shift = 1e-5;
    const auto potential = [&](const Vec3d& moved, const Vec3d& turned) {  // about the centre of mass
      const Quaternion after = (Quaternion::from_rotation(turned) * attitude).normalised();
      const Vec3d com = body.position_of_com() + moved;
      return hydrostatics(RigidBody(properties, Pose(com - Pose({}, after).turn_to_world(properties.centre_of_mass), after), {}, {}, all_free), box, sea)
          .potential;
    };
    // a third derivative of ρ g L² 1e4 N/m² gives 1e4 × 1e-10/6; energies of 1e5 J are rounded at 1e-11 J, over 2e-5 m: 1e-6 N each, summed. Where an edge
    // lies in the water's surface the second derivative jumps by as much as ρ g L B, which times 1e-5 m is 1 N
    const double tolerance = 1.0;
    CHECK(std::fabs(now.force + (potential({0, 0, shift}, {}) - potential({0, 0, -shift}, {})) / (2 * shift)) < tolerance);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3d turn{};
      turn[axis] = shift;
      CHECK(std::fabs(now.moment[axis] + (potential({}, turn) - potential({}, -turn)) / (2 * shift)) < tolerance);
    }
  }
}

TEST_CASE("still water: box, sphere and horizontal cylinder float in equilibrium by Archimedes' principle") {
  const auto level = [&](const Panels& panels, double mass) {
    const Surface surface(panels);
    return level_at_rest(RigidBody({.mass = mass}, Pose({0, 0, 3}), {}, {}, heave), surface, sea);
  };
  CHECK(*level(make_box({.size = size, .edge_length = 0.5}), 2000) == fixtures::relative(3 - 0.5 + 2000 / (1025.0 * 8), 1e-14));  // roundings
  // half of a surface that is mirror-symmetric including its panels
  const Panels ball = make_sphere({.diameter = 2, .edge_length = 0.1}), log = make_cylinder({.diameter = 1, .height = 3, .axis = Axis::x, .edge_length = 0.05});
  for (const Panels& panels : {ball, log}) CHECK(std::fabs(*level(panels, 0.5 * 1025 * Surface(panels).report().volume) - 3) < 1e-12);
  // a cap with the height of a quarter of the diameter has 5/32 of the sphere's volume
  CHECK(*level(ball, 1025 * 4 * std::numbers::pi / 3 * 5 / 32) == fixtures::relative(3 - 0.5, 0.01 * 0.1));  // panel²/8 inside, on a waterplane of 3/4 π
  CHECK(!level(make_box({.size = size, .edge_length = 0.5}), 8201).has_value());                             // 8200 kg of water
}

TEST_CASE("still water: a heeled box rights itself with the moment of the wall-sided formula") {
  const Surface box = make_box_surface();
  for (const double angle : {0.02, 0.1, 0.3, -0.4}) {
    const RigidBody body = afloat_box(box, 0, roll, Quaternion::from_rotation({angle, 0, 0}));
    const double draft = 0.5, tangent = std::tan(angle);
    const double bm = size.y * size.y / (12 * draft), bg = 0.25;  // [m] of the centre of mass, in the middle, over the one of buoyancy
    const double arm = (bm - bg + 0.5 * bm * tangent * tangent) * std::sin(angle);
    const Hydrostatics now = hydrostatics(body, box, sea);
    CHECK(now.moment.x == fixtures::relative(-body.mass() * sea.gravity * arm, 1e-12));  // exact up to rounding
    CHECK(std::fabs(now.force) < 1e-9 * body.mass());                                    // likewise
  }
}

TEST_CASE("still water: a box heaves with the period of its waterplane, slower with added mass") {
  const Surface box = make_box_surface();
  for (const double share : {0.0, 0.8}) {
    RigidBodyProperties properties = solid_of_mass(box.report(), 4100);
    properties.added_mass.z = share * 4100;
    RigidBody body(properties, Pose({0, 0, sea.level + 0.1}), {}, {}, heave);
    const double exact = 2 * std::numbers::pi * std::sqrt(4100 * (1 + share) / (sea.density * sea.gravity * size.x * size.y));
    const auto times = upward_crossings(
        10, 1e-3, [&] { return body.position_of_com().z - sea.level; },
        [&](const Step& step) {
          apply(sea, box, body, step);
          body.advance(step.dt);
        });
    REQUIRE(times.size() > 3);
    // linear, so exact except for (ω dt)²/24 = 1e-6 and the linear interpolation of the crossing
    CHECK((times.back() - times.front()) / static_cast<double>(times.size() - 1) == fixtures::relative(exact, 1e-5));
  }
}

TEST_CASE("still water: a box rolls with the period of its metacentric height") {
  const Surface box = make_box_surface();
  const double start = 0.01;
  RigidBody body = afloat_box(box, 0, roll, Quaternion::from_rotation({start, 0, 0}));
  const double gm = size.y * size.y / (12 * 0.5) - 0.25, inertia = body.mass() * (size.y * size.y + size.z * size.z) / 12;
  double angle = start;
  const auto times = upward_crossings(
      20, 1e-3, [&] { return angle; },
      [&](const Step& step) {
        apply(sea, box, body, step);
        body.advance(step.dt);
        angle += step.dt * body.angular_velocity().x;
      });
  REQUIRE(times.size() > 3);
  const double exact = 2 * std::numbers::pi * std::sqrt(inertia / (body.mass() * sea.gravity * gm));
  CHECK((times.back() - times.front()) / static_cast<double>(times.size() - 1) == fixtures::relative(exact, 3e-4));  // the arm grows by start²
}

TEST_CASE("still water: the work equals the gain of kinetic energy, and the loss of potential to second order in the step") {
  // a sphere, with a waterplane that changes as it heaves, far out of the water and below it
  const Surface ball(make_sphere({.diameter = 2, .edge_length = 0.2}));
  double last = 0;
  for (const double dt : {8e-3, 4e-3, 2e-3}) {
    RigidBody body(solid_of_mass(ball.report(), 1500), Pose({0, 0, 1.7}), {}, {}, heave);
    const double first = hydrostatics(body, ball, sea).potential;
    double work = 0, worst = 0;
    for (long n = 0; n < std::lround(20 / dt); ++n) {
      // the velocity at the position is the mean of those of the half steps before and after
      const double before = body.velocity().z, potential = hydrostatics(body, ball, sea).potential;
      work += apply(sea, ball, body, step_from(n, dt)).work;
      REQUIRE(std::fabs(work - body.kinetic_energy()) < 1e-11 * std::fabs(first));  // thousands of roundings
      const double mean = 0.5 * (before + body.velocity().z);
      if (n > 0) worst = fixtures::larger(worst, std::fabs(0.5 * body.mass() * mean * mean + potential - first));
      body.advance(dt);
    }
    CHECK(worst < 1e-3 * std::fabs(first));
    if (last > 0) CHECK(last / worst == fixtures::relative(4, 0.1));  // second order, without accumulation over a dozen periods
    last = worst;
  }
}

TEST_CASE("still water: with damping a dropped body comes to rest at its draft, without damping in air") {
  const Surface ball(make_sphere({.diameter = 2, .edge_length = 0.2}));
  StillWater thick = sea;
  thick.damping = 3;
  RigidBody body(solid_of_mass(ball.report(), 1500), Pose({0, 0, 2}), {}, {}, heave);
  const double rest = *level_at_rest(body, ball, thick);
  const double dt = 2e-3;
  apply(thick, ball, body, step_from(0, dt));
  CHECK(body.velocity().z == fixtures::relative(-thick.gravity * dt, 1e-15));
  for (long n = 1; n < std::lround(40 / dt); ++n) {
    apply(thick, ball, body, step_from(n, dt));
    body.advance(dt);
  }
  CHECK(std::fabs(*level_at_rest(body, ball, thick) - thick.level) < 1e-6);  // it decays with 3/2 per second over 40 s
  CHECK(std::fabs(rest - thick.level) > 0.1);
  CHECK(std::fabs(hydrostatics(body, ball, thick).force) < 1e-6 * 1500 * 9.81);
}

TEST_CASE("still water: damping reduces heave, roll and pitch by the same share, and does not affect yaw") {
  const Surface box = make_box_surface();
  StillWater thick{.level = 100, .density = 1025, .gravity = 1e-12, .damping = 2};
  RigidBodyProperties properties = solid_of_mass(box.report(), 8200);  // neutrally buoyant, with negligible weight and buoyancy
  properties.added_mass.z = 1000;
  RigidBody body(properties, Pose(), {1, 2, 3}, {0, 0.5, 0}, all_free);
  for (long n = 0; n < 1000; ++n) {
    apply(thick, box, body, step_from(n, 1e-3));
    body.advance(1e-3);
  }
  const double left = std::exp(-2.0);  // one second of it, exactly
  CHECK(norm(body.velocity() - Vec3d{1, 2, 3 * left}) < 1e-9);
  CHECK(norm(body.angular_velocity() - Vec3d{0, 0.5 * left, 0}) < 1e-9);
  RigidBody spinning(properties, Pose(), {}, {0, 0, 1}, all_free);
  for (long n = 0; n < 100; ++n) {
    apply(thick, box, spinning, step_from(n, 1e-3));
    spinning.advance(1e-3);
  }
  CHECK(norm(spinning.angular_velocity() - Vec3d{0, 0, 1}) < 1e-12);
}

TEST_CASE("still water: constrained degrees do not respond, and their reactions balance weight, buoyancy and their work") {
  const Surface box = make_box_surface();
  RigidBody held(solid_of_mass(box.report(), 4100), Pose({0, 0, -0.3}), {0, 0, 0.5}, {}, {});  // rises at a prescribed speed
  double work = 0, impulse = 0;
  const double before = hydrostatics(held, box, sea).potential, dt = 1e-3;
  for (long n = 0; n < 1000; ++n) {
    const WaterSum sum = apply(sea, box, held, step_from(n, dt));
    work += sum.work, impulse += sum.impulse;
    held.advance(dt);
  }
  CHECK(held.velocity() == Vec3d{0, 0, 0.5});
  CHECK(held.position_of_com().z == fixtures::relative(0.2, 1e-12));
  CHECK(held.constraint_work() == fixtures::relative(-work, 1e-12));
  // forces are those at the start of a step: too large by half a step's change, ρ g A 0.5 m/s dt/2, along the 0.5 m; up to rounding
  const double ahead = work - (before - hydrostatics(held, box, sea).potential);
  CHECK(ahead == fixtures::relative(sea.density * sea.gravity * 8 * 0.5 * 0.5 * dt * 0.5, 1e-6));
  CHECK(impulse == fixtures::relative(work / 0.5, 1e-12));
}

TEST_CASE("still water: numbers that are not finite or negative, and open surfaces, are refused in a sentence, and the body is left as it was") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Surface box(make_box({.size = {1, 1, 1}}));
  Panels tray = make_box({.size = {1, 1, 1}});
  tray.panels.erase(tray.panels.begin());
  const Surface open(tray, {.orientation = Orientation::normals});
  RigidBody body({.mass = 100, .inertia = Mat3::identity()}, Pose({0, 0, -0.2}), {}, {}, {{true, true, true, true, true, true}});
  const auto refusals = [&](const StillWater& water, const Surface& surface, const std::string& sentence) {
    CHECK_THROWS_WITH_AS(hydrostatics(body, surface, water), sentence.c_str(), InputError);
    CHECK_THROWS_WITH_AS(apply(water, surface, body, {0, 0.1, 0.1}), sentence.c_str(), InputError);
    CHECK_THROWS_WITH_AS(level_at_rest(body, surface, water), sentence.c_str(), InputError);
    CHECK(body.velocity() == Vec3d{});
  };
  refusals({.level = nan}, box, "still water: the level is nan, but it must be finite.");
  refusals({.density = -1000}, box, "still water: the density is -1000, but it must be a finite number of at least 0.");
  refusals({.density = infinity}, box, "still water: the density is inf, but it must be a finite number of at least 0.");
  refusals({.gravity = -9.81}, box, "still water: the gravity is -9.81, but it must be a finite number of at least 0.");
  refusals({.gravity = nan}, box, "still water: the gravity is nan, but it must be a finite number of at least 0.");
  refusals({.damping = -5}, box, "still water: the damping is -5, but it must be a finite number of at least 0.");
  refusals({.damping = nan}, box, "still water: the damping is nan, but it must be a finite number of at least 0.");
  refusals({}, open, "still water: the surface of the body is open, so it displaces no volume; close its holes.");
}
