// The limit of stability of whole bodies, surfaces and corrections included, against dense matrices and runs on both sides of it.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/particles/advance.hpp"
#include "perimpact/simulation/simulation.hpp"

using namespace perimpact;
using fixtures::BodyOptions;
using fixtures::Model;
using fixtures::Points;

namespace {

/// 2/ω of the stiffest mode [s]: the stiffness as a dense matrix, column by column from the body's forces, and power iteration.
double limit_by_matrix(Body body) {
  constexpr double moved = 1e-9;  // [m], a millionth of the spacing: the force is linear to as much
  const std::size_t axes = body.particles.is_plane() ? 2 : 3;
  const auto slots = body.particles.slot_of();
  const std::size_t size = slots.size() * axes;
  const auto root_mass = [&](std::size_t n) { return std::sqrt(body.particles.mass(slots[n / axes])); };
  std::vector<double> matrix(size * size);  // M^-1/2 K M^-1/2
  for (std::size_t column = 0; column < size; ++column) {
    const std::size_t slot = slots[column / axes];
    const auto force_at = [&](double shift) {
      Vec3d position = body.particles.reference(slot);
      position[column % axes] += shift;
      body.particles.position.set(slot, position);
      body.internal.evaluate_unbroken(body.particles, body.family);
      std::vector<double> force(size);
      for (std::size_t row = 0; row < size; ++row)
        force[row] = body.particles.force_density.at(slots[row / axes])[row % axes] * body.particles.volume(slots[row / axes]);
      return force;
    };
    const std::vector<double> ahead = force_at(moved), behind = force_at(-moved);
    body.particles.position.set(slot, body.particles.reference(slot));
    for (std::size_t row = 0; row < size; ++row) matrix[row * size + column] = (behind[row] - ahead[row]) / (2 * moved * root_mass(row) * root_mass(column));
  }
  std::mt19937_64 random(3);
  std::normal_distribution<double> number;
  std::vector<double> vector(size), product(size);
  for (double& one : vector) one = number(random);
  double found = 0;
  for (int sweep = 0; sweep < 4000; ++sweep) {
    double length = 0, along = 0, before = 0;
    for (std::size_t row = 0; row < size; ++row) {
      double sum = 0;
      for (std::size_t column = 0; column < size; ++column) sum += matrix[row * size + column] * vector[column];
      product[row] = sum;
      length += sum * sum, along += sum * vector[row], before += vector[row] * vector[row];
    }
    const double quotient = along / before;
    for (std::size_t row = 0; row < size; ++row) vector[row] = product[row] / std::sqrt(length);
    if (sweep > 50 && std::fabs(quotient - found) < 1e-7 * quotient) break;
    found = quotient;
  }
  return 2 / std::sqrt(found);
}

/// Total energy after a number of steps, over the first, of a body shaken so little that all is linear.
double energy_after(Body body, double dt, int steps) {
  std::vector<double> travel(travel_blocks(body.particles));
  fixtures::shake(body, 1e-9);
  double energy = body.internal.evaluate_with_energy(body.particles, body.family);
  const double first = energy;
  for (int step = 0; step < steps; ++step) {
    advance(body.particles, dt, travel);
    energy = body.internal.evaluate_with_energy(body.particles, body.family);
  }
  return (energy + body.motion(dt).kinetic_energy) / first;
}

/// Every law, correction, dimension and kind of points, over Poisson's ratios from 0 to nearly one half.
std::vector<fixtures::NamedOptions> bodies_of(Plane plane, Points points) {
  std::vector<fixtures::NamedOptions> all;
  const auto add = [&](const char* name, BodyOptions options) {
    options.size = plane == Plane::none ? Vec3d{0.005, 0.004, 0.004} : Vec3d{0.008, 0.007, 0.001};
    options.plane = plane, options.points = points;
    all.push_back({name, options});
  };
  for (const double nu : {0.0, 0.25, 0.35, 0.45, 0.49}) {
    for (const SurfaceCorrection correction : {SurfaceCorrection::none, SurfaceCorrection::energy, SurfaceCorrection::volume})
      add("ordinary state", {.poissons_ratio = nu, .correction = correction});
    for (const Influence influence : {Influence::constant, Influence::inverse, Influence::inverse_square})
      add("linear solid", {.poissons_ratio = nu, .model = Model::linear_solid, .influence = influence});
    for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan, Stabilisation::silling})
      add("correspondence", {.poissons_ratio = nu, .model = Model::correspondence, .stabilisation = stabilisation});
  }
  for (const SurfaceCorrection correction : {SurfaceCorrection::none, SurfaceCorrection::energy, SurfaceCorrection::volume})
    add("bond-based", {.correction = correction, .model = Model::bond_based});
  return all;
}

void check_limits(Plane plane, Points points) {
  for (const fixtures::NamedOptions& one : bodies_of(plane, points)) {
    CAPTURE(one.name);
    CAPTURE(one.options.poissons_ratio);
    CAPTURE(static_cast<int>(one.options.correction));
    const Body body = fixtures::body(one.options);
    const double limit = limit_by_matrix(body);
    CHECK(exact_stable_step(body) == fixtures::relative(limit, 0.005));  // forty products of Lanczos' method, from below in ω² by up to 0.7 %
    CHECK(safe_stable_step(body) < limit);
    CHECK(safe_stable_step(body) > 0.35 * limit);                      // nor needlessly short: 0.38 is the least, of a linear solid at ν = 0.49
    CHECK(energy_after(body, 0.98 * limit, 200) < 50);                 // near the limit an oscillator's energy swings by 1/(1 - (ω dt/2)²) = 25
    CHECK_FALSE(energy_after(body, 1.02 * limit, 200) < 1e6);          // where it grows, it does by 1.5 a step
    CHECK(energy_after(body, 0.9 * safe_stable_step(body), 200) < 6);  // the automatic step: 1/(1 - 0.9²)
  }
}

}  // namespace

TEST_CASE("stable step: in 3-D, a lattice conserves its energy at 0.98 of the exact limit and is unstable at 1.02, for any law") {
  check_limits(Plane::none, Points::lattice);
}
TEST_CASE("stable step: in 3-D, a point cloud conserves its energy at 0.98 of the exact limit and is unstable at 1.02, for any law") {
  check_limits(Plane::none, Points::shaken);
}
TEST_CASE("stable step: in plane strain, both conserve their energy at 0.98 of the exact limit and are unstable at 1.02, for any law") {
  check_limits(Plane::strain, Points::lattice);
  check_limits(Plane::strain, Points::shaken);
}
TEST_CASE("stable step: in plane stress, both conserve their energy at 0.98 of the exact limit and are unstable at 1.02, for any law") {
  check_limits(Plane::stress, Points::lattice);
  check_limits(Plane::stress, Points::shaken);
}

TEST_CASE("stable step: the automatic step of a nearly incompressible block is below its limit, and a step above that is refused") {
  Setup setup;
  setup.bodies.push_back(fixtures::body_setup({.size = {0.008, 0.010, 0.012}, .poissons_ratio = 0.48}));
  setup.time.end = 1e-4;
  Simulation simulation(setup);
  const double exact = exact_stable_step(simulation.bodies()[0]);
  CHECK(simulation.stability().estimate < exact);
  CHECK(!simulation.stability().exact);  // not computed
  const double automatic = simulation.stability().step;
  CHECK(energy_after(simulation.bodies()[0], automatic, 300) < 6);  // as above

  setup.time.step = 0.99 * exact;
  const Simulation near(setup);
  CHECK(near.stability().exact.value() == fixtures::relative(exact, 1e-12));  // the same sums
  CHECK(!near.warnings().empty());
  setup.time.step = 1.01 * exact;
  CHECK_THROWS_WITH_AS(Simulation{setup}, doctest::Contains("and unstable"), SetupError);
}

TEST_CASE("stable step: for any bond failure in a nearly incompressible body, the initial estimate stays below the exact limit") {
  for (const Plane plane : {Plane::none, Plane::strain})
    for (const Model model : {Model::ordinary_state, Model::linear_solid})
      for (const double nu : {0.35, 0.48}) {
        const Body whole = fixtures::body(
            {.size = plane == Plane::none ? Vec3d{0.008, 0.007, 0.006} : Vec3d{0.016, 0.016, 0.001}, .poissons_ratio = nu, .model = model, .plane = plane});
        const double estimate = safe_stable_step(whole);
        for (const double share : {0.2, 0.5, 0.8}) {
          CAPTURE(share);
          Body damaged = whole;
          damaged.family.cut([share](std::size_t i, std::size_t j) { return fixtures::drawn(i, j) < share; });
          CHECK(exact_stable_step(damaged) > estimate);
          CHECK(safe_stable_step(damaged) >= estimate);
        }
        Body parted = whole;  // along a plane of the lattice
        parted.family.cut([&](std::size_t i, std::size_t j) { return (whole.particles.reference(i).x > 0) != (whole.particles.reference(j).x > 0); });
        CHECK(exact_stable_step(parted) > estimate);
        CHECK(safe_stable_step(parted) >= estimate);
      }
}

TEST_CASE("stable step: up to a Poisson's ratio of 0.3 the estimate is bitwise that of Silling and Askari") {
  for (const double nu : {0.0, 0.1, 0.25, 0.3})
    for (const Points points : {Points::lattice, Points::shaken}) {
      CAPTURE(nu);
      const Body body = fixtures::body({.size = {0.010, 0.007, 0.006}, .poissons_ratio = nu, .points = points});
      CHECK(safe_stable_step(body) == silling_askari_step(body));
    }
}
