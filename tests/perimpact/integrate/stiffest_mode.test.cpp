#include "perimpact/integrate/stiffest_mode.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/particles/advance.hpp"

using namespace perimpact;
using fixtures::BodyOptions;
using fixtures::Model;
using fixtures::Points;

namespace {

/// Total energy after a number of steps, over the first, of a body shaken so little that all is linear.
double energy_after(BodyOptions options, double dt, int steps) {
  Body solid = fixtures::body(options);
  std::vector<double> travel(travel_blocks(solid.particles));
  fixtures::shake(solid, 1e-9);
  double energy = solid.internal.evaluate_with_energy(solid.particles, solid.family);
  const double first = energy;
  for (int step = 0; step < steps; ++step) {
    advance(solid.particles, dt, travel);
    energy = solid.internal.evaluate_with_energy(solid.particles, solid.family);
  }
  return (energy + solid.motion(dt).kinetic_energy) / first;
}

/// Correspondence on lattices and clouds, and the ordinary materials on clouds: all that have no formula of plane waves.
std::vector<fixtures::NamedOptions> some_bodies() {
  std::vector<fixtures::NamedOptions> all;
  for (auto& one : fixtures::every_body({0.008, 0.006, 0.005})) {
    const BodyOptions& options = one.options;
    const bool in_question = options.model == Model::correspondence
                                 ? options.points != Points::listed && options.law == StressLaw::hencky
                                 : options.points == Points::shaken && options.poissons_ratio > 0.2 && options.correction != SurfaceCorrection::volume &&
                                       options.influence == Influence::inverse;
    if (in_question && options.plane != Plane::strain) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

TEST_CASE("stiffest mode: two particles and their bond oscillate as two masses with a spring") {
  const double h = 0.001;
  BodySetup setup = fixtures::body_setup({.correction = SurfaceCorrection::none, .model = Model::bond_based});
  Body pair = make_body(setup, Particles(Cloud{{{0, 0, 0}, {h, 0, 0}}, {h * h * h, 2 * h * h * h}, {}}, fixtures::density));
  double row = 0;
  const auto slots = pair.particles.slot_of();
  for (const std::uint32_t slot : slots)
    pair.family.for_each_bond(slot, [&](const FamilyBond& bond) { row += pair.internal.bond_stiffness(slot, bond) * bond.volume / fixtures::density; });
  CHECK(stiffest_mode(pair) == fixtures::relative(row, 1e-6));  // ω² = k (1/m₁ + 1/m₂); the force is linear to 1e-6
}

TEST_CASE("stiffest mode: forty products converge from below and within one per cent of two hundred") {
  for (const fixtures::NamedOptions& one : some_bodies()) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    const Body solid = fixtures::body(options);
    const double forty = stiffest_mode(solid), many = stiffest_mode(solid, 200);
    CHECK(forty <= many * (1 + 1e-6));  // of rounding, and of forces that are linear to 1e-6
    CHECK(forty >= 0.99 * many);
  }
}

TEST_CASE("stiffest mode: the result does not depend on the positions and leaves the body unchanged") {
  Body solid = fixtures::body({.poissons_ratio = 0.3, .critical_stretch = 1e-9, .model = Model::correspondence});
  const double before = stiffest_mode(solid);
  fixtures::shake(solid, 1e-5);
  CHECK(stiffest_mode(solid) == before);
  CHECK(solid.internal.broken_bonds() == 0);
}

TEST_CASE("exact stable step: just below it a body conserves its energy, just above it becomes unstable") {
  for (const auto& options : {BodyOptions{.size = {0.010, 0.007, 0.006}, .poissons_ratio = 0.3, .model = Model::correspondence},
                              BodyOptions{.size = {0.010, 0.007, 0.006},
                              .poissons_ratio = 0.3,
                              .model = Model::correspondence,
                              .stabilisation = Stabilisation::silling,
                              .points = Points::shaken},
                              BodyOptions{.size = {0.010, 0.007, 0.006}, .poissons_ratio = 0.25, .points = Points::shaken}}) {
    const double exact = exact_stable_step(fixtures::body(options));
    CHECK(energy_after(options, 0.97 * exact, 200) < 20);  // near the limit the energy of an oscillator swings by 1/(1 - (ω dt/2)²) = 17
    CHECK_FALSE(energy_after(options, 1.03 * exact, 200) < 1e6);
  }
}

TEST_CASE("stable step: the estimate is below the exact limit of every body, and of correspondence by less than half") {
  for (const fixtures::NamedOptions& one : some_bodies()) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    const Body solid = fixtures::body(options);
    const double ratio = exact_stable_step(solid) / silling_askari_step(solid);
    CHECK(ratio > 1);
    if (options.model == Model::correspondence) CHECK(ratio < 2);
  }
}

TEST_CASE("stable step: at 0.9 of the estimate a perturbed block of correspondence conserves its energy") {
  for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff})
    for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan, Stabilisation::silling}) {
      const BodyOptions options{
          .size = {0.010, 0.007, 0.006}, .poissons_ratio = 0.3, .model = Model::correspondence, .law = law, .stabilisation = stabilisation};
      // ω dt is at most 1.5 here; only few modes are so fast, and with velocities brought to the end of the step their energy swings by (ω dt)²/4
      CHECK(energy_after(options, 0.9 * silling_askari_step(fixtures::body(options)), 200) == fixtures::relative(1, 0.25));
    }
}

TEST_CASE("stable step: for any bond failure in a body of correspondence, the initial estimate stays below the exact limit") {
  for (const Plane plane : {Plane::none, Plane::stress})
    for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan, Stabilisation::silling}) {
      const Body whole = fixtures::body({.size = plane == Plane::none ? Vec3d{0.008, 0.007, 0.006} : Vec3d{0.016, 0.016, 0.001},
                                         .poissons_ratio = 0.3,
                                         .model = Model::correspondence,
                                         .stabilisation = stabilisation,
                                         .plane = plane});
      const double estimate = silling_askari_step(whole);
      std::mt19937_64 random(1);
      std::normal_distribution<double> number;
      for (const double share : {0.5, 0.8, 0.95}) {
        CAPTURE(share);
        Body damaged = whole;
        damaged.family.cut([share](std::size_t i, std::size_t j) { return fixtures::drawn(i, j) < share; });
        CHECK(exact_stable_step(damaged) > 1.1 * estimate);
      }
      for (const int cracks : {1, 3, 10}) {  // through and through, at all angles
        CAPTURE(cracks);
        Body cracked = whole;
        for (int crack = 0; crack < cracks; ++crack) {
          const Vec3d normal = fccda::normalised({number(random), number(random), plane == Plane::none ? number(random) : 0});
          const double at = 0.002 * number(random);
          const auto side = [&](std::size_t slot) { return dot(normal, whole.particles.reference(slot)) > at; };
          cracked.family.cut([&](std::size_t i, std::size_t j) { return side(i) != side(j); });
        }
        CHECK(exact_stable_step(cracked) > 1.1 * estimate);
      }
    }
}
