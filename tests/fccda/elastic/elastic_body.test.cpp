#include "fccda/elastic/elastic_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fccda/elastic/impacts.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

namespace {

RigidBody held(const FreeDegrees& degrees = {}, const Vec3d& velocity = {}, const Vec3d& spin = {}) {
  return RigidBody({.mass = 2, .inertia = Mat3::diagonal({0.3, 0.3, 0.5})}, Pose(), velocity, spin, degrees);
}

/// A mode in which a sheet of mass M moves up and down as a whole: the sheet on a spring.
Mode on_spring(const Panels& panels, double mass, double frequency, double damping) {
  return {.angular_frequency = 2 * std::numbers::pi * frequency,
          .damping_ratio = damping,
          .shape = std::vector<Vec3d>(panels.vertices.size(), Vec3d{0, 0, 1 / std::sqrt(mass)})};
}

/// Waves along x and y, as of a free sheet.
Modes waves(const Panels& panels, double mass) {
  Modes modes;
  for (int k = 1; k <= 6; ++k) {
    Mode& mode = modes.emplace_back(Mode{.angular_frequency = 200.0 * k, .damping_ratio = 0.01 * k});
    for (const Vec3d& x : panels.vertices)
      mode.shape.push_back(std::sqrt(2 / mass) * Vec3d{0.1 * std::sin(k * x.y), 0, std::cos(std::numbers::pi * k * (k % 2 ? x.x : x.y))});
  }
  return modes;
}

struct Rebound {
  double speed, contact_time, sheet_momentum;
};

/// A point of mass m meets a sheet of mass M on a spring of 50 Hz.
Rebound rebound(double m, double M, int steps_of_period) {
  const Panels panels = sheet(4);
  const auto surface = open_surface(panels);
  RigidBody body = held();
  constexpr double frequency = 50;
  ElasticBody elastic(body, {on_spring(panels, M, frequency, 0)}, panels.vertices);
  Impacts impacts(elastic, surface, 0);
  impacts.add({0.07, -0.03, 1e-3}, {0, 0, -3}, m);
  const double dt = 1 / (frequency * steps_of_period);
  Rebound found{};
  for (int step = 0; step < 2 * steps_of_period; ++step) {
    impacts.step(dt);
    if (impacts.impulse.z != 0) found.contact_time += dt;
  }
  found.speed = impacts.points.v[0].z;
  return found;
}

}  // namespace

TEST_CASE("elastic body: a point that meets a sheet on a spring leaves it after half a period of both together, at their common speed") {
  for (const double m : {0.2, 1.0, 5.0}) {
    constexpr double M = 1, v = 3;
    const Rebound found = rebound(m, M, 4000);
    const double half_period = 0.5 / 50 * std::sqrt((m + M) / M);
    // the impact is perfectly inelastic, the oscillation afterwards conserves energy; times are whole steps
    CHECK(found.speed == fixtures::relative(v * m / (m + M), 2e-3));
    CHECK(found.contact_time == fixtures::relative(half_period, 2e-3));
  }
  const double coarse = rebound(1, 1, 250).speed - 1.5, fine = rebound(1, 1, 4000).speed - 1.5;
  CHECK(std::fabs(fine) < 0.25 * std::fabs(coarse));
}

namespace {

struct Shower {
  double loosest = 0;              // [N s] largest change of momentum
  double angular = 0;              // [N m s] change of angular momentum
  double first, last, gained = 0;  // [J] energy, and the most that a step adds
  double speed;                    // [m/s] mean of the points along z, at the end
  int most_passes;
};

/// 400 points fall on a free sheet that moves and turns, within 40 ms.
Shower shower(double friction, double dt) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Panels panels = sheet(8);
  const auto surface = open_surface(panels);
  RigidBody body = held({{true, true, true, true, true, true}}, {0.1, 0, 0.4}, {0.5, -0.2, 1});
  ElasticBody elastic(body, waves(panels, 2), panels.vertices);
  Impacts impacts(elastic, surface, 0.01);
  impacts.friction = friction;
  for (int i = 0; i < 400; ++i) impacts.add({0.45 * unit(random), 0.45 * unit(random), 0.02 + 0.05 * std::fabs(unit(random))}, {unit(random), 0, -3}, 0.01);
  const auto momentum = [&] { return impacts.momentum() + body.momentum(); };
  const auto angular = [&] { return impacts.angular_momentum() + body.angular_momentum({}); };
  const auto energy = [&] {
    return impacts.kinetic_energy() + body.kinetic_energy() + elastic.kinetic_energy_of_scheme() + elastic.elastic_energy() + elastic.damping_dissipation();
  };
  const Vec3d before = momentum(), angular_before = angular();
  Shower found;
  found.first = found.last = energy();
  for (double t = 0; t < 0.04; t += dt) {
    impacts.step(dt);
    found.gained = fixtures::larger(found.gained, energy() - found.last);
    found.last = energy();
    found.loosest = fixtures::larger(found.loosest, norm(momentum() - before));
  }
  found.angular = norm(angular() - angular_before);
  found.speed = impacts.momentum().z / 4;
  found.most_passes = impacts.most_passes;
  return found;
}

}  // namespace

TEST_CASE("elastic body: momentum of points and a free body is conserved, and energy never grows") {
  for (const double friction : {0.0, 0.4}) {
    const Shower found = shower(friction, 1e-4), finer = shower(friction, 2.5e-5);
    CHECK(found.loosest == fixtures::absolute(0, 1e-12 * 12, "N s"));  // the points bring 12 N s
    CHECK(found.gained <= 1e-4 * found.first);
    CHECK(found.last < 0.9 * found.first);
    CHECK(found.speed > -2);  // many have bounced
    // lever arms end at the places at t1: of first order in dt
    CHECK(found.angular < 1e-3);
    CHECK(finer.angular < 0.5 * found.angular);
    if (friction == 0) CHECK(found.most_passes < StructureCoupling::max_passes);
  }
}

namespace {

/// A ball at rest in front of the middle of a membrane that vibrates in its first mode, and what remains of both after some impacts.
struct AfterImpacts {
  double impulse = 0;          // [N s] on the ball
  double energy = 0;           // [J] of ball and membrane
  int impacts = 0;             // beginnings of contact
  double membrane_energy = 0;  // [J]
};

constexpr double ball_mass = 0.3, modal_mass = 0.8, membrane_frequency = 40, vibration = 0.01, gap = 0.004, ball_speed = -0.5, watched = 0.06;

/// By the equations of motion: a mass on a spring and a free mass, joined by perfectly inelastic impacts as long as they press on each other. Times of impact
/// and of separation are found to 1e-7 s.
AfterImpacts by_equations_of_motion() {
  const double w = 2 * std::numbers::pi * membrane_frequency, k = modal_mass * w * w, dt = 1e-7;
  double x = 0, v = vibration * w, y = gap, u = ball_speed;
  bool joined = false;
  AfterImpacts found;
  for (double t = 0; t < watched; t += dt) {
    const double before = u;
    v -= dt * k * x / (joined ? modal_mass + ball_mass : modal_mass);
    if (joined) u = v;
    x += dt * v, y += dt * u;
    if (joined) y = x;
    if (joined && x > 0) joined = false;  // the spring would pull the ball back
    if (!joined && y <= x && u < v) {
      joined = true, ++found.impacts;
      u = v = (modal_mass * v + ball_mass * u) / (modal_mass + ball_mass);
    }
    found.impulse += ball_mass * (u - before);
  }
  found.membrane_energy = 0.5 * modal_mass * v * v + 0.5 * k * x * x;
  found.energy = found.membrane_energy + 0.5 * ball_mass * u * u;
  return found;
}

}  // namespace

TEST_CASE("elastic body: a ball on a vibrating membrane exchanges impulse and energy as the equations of motion say") {
  const Panels panels = sheet(16);
  const auto surface = open_surface(panels);
  RigidBody body = held();
  Mode first{.angular_frequency = 2 * std::numbers::pi * membrane_frequency};
  for (const Vec3d& x : panels.vertices)
    first.shape.push_back({0, 0, std::cos(std::numbers::pi * x.x) * std::cos(std::numbers::pi * x.y) / std::sqrt(modal_mass)});
  ElasticBody elastic(body, {first}, panels.vertices);
  elastic.visit_state([&](std::string_view name, auto&& values) {
    if (name == "modal_velocities") numbers_in(values)[0] = vibration * first.angular_frequency * std::sqrt(modal_mass);
  });
  constexpr double radius = 0.002;  // small beside the curvature of the mode
  Impacts impacts(elastic, surface, radius);
  impacts.add({0, 0, gap + radius}, {0, 0, ball_speed}, ball_mass);
  AfterImpacts found;
  bool joined = false;
  constexpr double dt = 1e-5;
  for (double t = 0; t < watched; t += dt) {
    const double before = impacts.points.v[0].z;
    impacts.step(dt);
    found.impulse += ball_mass * (impacts.points.v[0].z - before);
    if (impacts.impulse.z != 0 && !joined) ++found.impacts;
    joined = impacts.impulse.z != 0;
  }
  found.membrane_energy = elastic.kinetic_energy_of_scheme() + elastic.elastic_energy();
  found.energy = found.membrane_energy + impacts.kinetic_energy();
  const AfterImpacts expected = by_equations_of_motion();
  REQUIRE(expected.impacts >= 1);
  REQUIRE(expected.membrane_energy > 0.1 * expected.energy);
  CHECK(found.impulse == fixtures::relative(expected.impulse, 0.01));
  CHECK(found.energy == fixtures::relative(expected.energy, 0.01));
  CHECK(found.membrane_energy == fixtures::relative(expected.membrane_energy, 0.01));
}

TEST_CASE("elastic body: a damped mode oscillates exactly, and energy and dissipation are those of the start") {
  const Panels panels = sheet(2);
  RigidBody body = held();
  constexpr double frequency = 20, damping = 0.1, M = 3;
  ElasticBody elastic(body, {on_spring(panels, M, frequency, damping)}, panels.vertices);
  std::vector<Vec3d> vertices(panels.vertices.size());
  std::vector<double> impulse(7, 0.0), none(7, 0.0);
  elastic.add_vertex_impulse(4, {0, 0, 0.6}, impulse);
  constexpr double dt = 2e-3;  // θ = 0.25
  for (int step = 0; step < 40; ++step) {
    elastic.begin({0, dt, dt});
    elastic.move(step == 0 ? impulse : none, vertices);
    elastic.finish(step == 0 ? impulse : none, step == 0 ? impulse : none);
    const double t = (step + 1) * dt, w = 2 * std::numbers::pi * frequency, wd = w * std::sqrt(1 - damping * damping);
    CHECK(vertices[4].z == fixtures::absolute(0.6 / M * std::exp(-damping * w * t) * std::sin(wd * t) / wd, 1e-14, "m"));
    const double energy = elastic.kinetic_energy_of_scheme() + elastic.elastic_energy() + elastic.damping_dissipation();
    CHECK(energy == fixtures::relative(0.5 * 0.6 * 0.6 / M, 1e-12));
  }
}

TEST_CASE("elastic body: a resumed state continues bitwise") {
  const Panels panels = sheet(4);
  const auto impacts_on = [&](ElasticBody& elastic, const std::shared_ptr<DeformingSurface>& surface) {
    Impacts impacts(elastic, surface, 0);
    impacts.add({0.1, 0.2, 1e-3}, {0.3, 0, -2}, 0.4);
    return impacts;
  };
  const auto surface = open_surface(panels), other_surface = open_surface(panels);
  RigidBody body = held({{true, true, true, false, false, false}}), other_body = body;
  ElasticBody elastic(body, waves(panels, 2), panels.vertices), other(other_body, waves(panels, 2), panels.vertices);
  Impacts whole = impacts_on(elastic, surface);
  for (int step = 0; step < 20; ++step) whole.step(1e-4);
  std::vector<std::vector<double>> state;
  const auto write = [&](std::string_view, auto&& values) {
    std::vector<double>& kept = state.emplace_back();
    for (const auto value : numbers_in(values)) kept.push_back(static_cast<double>(value));
  };
  body.visit_state(write), elastic.visit_state(write);
  std::size_t next = 0;
  const auto read = [&](std::string_view, auto&& values) {
    auto numbers = numbers_in(values);
    REQUIRE(numbers.size() == state[next].size());
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<std::remove_reference_t<decltype(numbers[k])>>(state[next][k]);
    ++next;
  };
  other_body.visit_state(read), other.visit_state(read);
  std::vector<Vec3d> vertices(panels.vertices.size());
  other.place(vertices);
  other_surface->place(vertices);
  Impacts resumed = impacts_on(other, other_surface);
  resumed.points = whole.points;
  for (int step = 0; step < 60; ++step) {
    whole.step(1e-4), resumed.step(1e-4);
    REQUIRE(whole.points.x1[0] == resumed.points.x1[0]);
  }
  CHECK(std::ranges::equal(elastic.amplitudes(), other.amplitudes()));
}

TEST_CASE("elastic body: modes that do not fit are refused with a sentence") {
  const Panels panels = sheet(2);
  RigidBody body = held();
  const auto complaint = [&](const auto& change) {
    Modes modes = {on_spring(panels, 1, 10, 0)};
    change(modes[0]);
    try {
      ElasticBody elastic(body, modes, panels.vertices);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint([](Mode&) {}).empty());
  CHECK(complaint([](Mode& mode) { mode.shape.pop_back(); }).find("8 vertices, but the surface has 9") != std::string::npos);
  CHECK(complaint([](Mode& mode) { mode.angular_frequency = 0; }).find("leave out rigid-body modes") != std::string::npos);
  CHECK(complaint([](Mode& mode) { mode.damping_ratio = 1; }).find("at least 0 and below 1") != std::string::npos);
  CHECK(complaint([](Mode& mode) { mode.shape[3].x = std::nan(""); }).find("not finite") != std::string::npos);
  CHECK(complaint([](Mode& mode) { mode.stress.resize(1); }).find("stresses at 1 vertices") != std::string::npos);
}
