#include "perimpact/body/failure.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/damage/strength.hpp"
#include "perimpact/materials/ordinary_state/fracture_energy.hpp"

using namespace perimpact;
using fixtures::body;
using fixtures::BodyOptions;
using fixtures::Points;

namespace {

constexpr double E = fixtures::youngs_modulus, horizon = 3.015e-3, thickness = 2e-3;

OrdinaryState continuum_law(Plane plane, double nu) {
  return OrdinaryState(IsotropicElastic::in(plane, E, nu), madenci_oterkus_influences, horizon, plane == Plane::none ? 1 : thickness, std::nullopt);
}

double unit_energy(Plane plane, double nu) {
  const OrdinaryState law = continuum_law(plane, nu);
  return fracture_energy_of_bonds(law, horizon, thickness) + fracture_energy_of_dilatation(law, horizon);
}

FailureSetup in_compression(CompressionFailure kind, std::optional<double> limit = {}) {
  FailureSetup failure;
  failure.compression.index = static_cast<int>(kind);
  failure.critical_compression = limit;
  return failure;
}

/// Broken bonds after a uniform stretch s of the body.
std::size_t broken_at(double s, const BodyOptions& options) {
  Body solid = body(options);
  fixtures::deform(solid, [&](const Vec3d& X) { return (1 + s) * X; });
  solid.internal.evaluate(solid.particles, solid.family);
  return solid.internal.broken_bonds();
}

}  // namespace

TEST_CASE("failure: the fracture energy of the continuum is that of the literature, in 3-D and 2-D") {
  // physics notes 1.9; Simpson's rule is exact for these powers
  const auto [mu, kappa] = std::pair(E / 2.6, E / (3 * 0.4));                                                         // ν = 0.3
  CHECK(unit_energy(Plane::none, 0.25) == fixtures::relative(9 * (E / 1.5) * horizon / 5, 1e-10));                    // 9 κ δ/5, bond-based
  CHECK(unit_energy(Plane::stress, 1.0 / 3) == fixtures::relative(9 * E * horizon / (4 * std::numbers::pi), 1e-10));  // bond-based
  CHECK(unit_energy(Plane::strain, 0.25) == fixtures::relative(12 * E * horizon / (5 * std::numbers::pi), 1e-10));    // bond-based
  CHECK(unit_energy(Plane::none, 0.3) == fixtures::relative((3 * mu + 81.0 / 256 * (kappa - 5 * mu / 3)) * horizon, 1e-10));
}

TEST_CASE("failure: the lattice has the tabulated fracture energy, so that a crack along its cells costs exactly the given energy") {
  for (const auto& [plane, ratio] : {std::pair(Plane::none, 1.07), std::pair(Plane::stress, 1.04)}) {
    BodyOptions options{.size = {0.02, 0.02, plane == Plane::none ? 0.008 : thickness},
                        .poissons_ratio = plane == Plane::none ? 0.25 : 1.0 / 3,
                        .normalisation = Normalisation::continuum,
                        .critical_stretch = 1e-3,
                        .plane = plane};
    const Body solid = body(options);
    // table 1.9: 1.07 in 3-D, 1.03 to 1.05 in 2-D, two digits, for constants of the continuum
    CHECK(solid.failure->fracture_energy / (1e-6 * unit_energy(options.plane == Plane::none ? Plane::none : Plane::stress, options.poissons_ratio)) ==
          fixtures::relative(ratio, 0.011));
  }
}

TEST_CASE("failure: separating a body along a plane of cells takes the given fracture energy") {
  // bonds across x = 0 at the critical stretch, one by one: Σ ½ (2 W_bond) over the pairs, from energies of pairs alone (a = 0)
  BodySetup setup = fixtures::body_setup({.size = {0.016, 0.012, 0.012}});
  auto& material = std::get<OrdinaryStateSetup>(setup.material);
  material.fracture_energy = 42.0;
  const Body solid = make_body(setup);
  const OrdinaryStateForce& force = *solid.internal.ordinary_state();
  double energy = 0;
  std::size_t columns = 0;
  for (const std::uint32_t slot : solid.particles.slot_of()) {
    const Vec3d X = solid.particles.reference(slot);
    if (X.x > 0 || std::fabs(X.y) > 0.001 || std::fabs(X.z) > 0.001) continue;  // the middle columns, whose families across are whole
    columns += std::fabs(X.x) < 0.001;
    solid.family.for_each_bond(slot, [&](const FamilyBond& bond) {
      if (solid.particles.reference(bond.j).x < 0) return;
      const double e = solid.failure->stretch * bond.length;
      energy += 2 * (force.law().bond_stiffness(bond.length) / 4) * e * e * bond.volume * solid.particles.volume(slot);
    });
  }
  CHECK(columns == 4);
  CHECK(energy / (static_cast<double>(columns) * 1e-6) == fixtures::relative(42.0, 1e-9));  // per area of crack; the same sums in another order
}

TEST_CASE("failure: each of the three parameters determines the other two, both ways") {
  const auto criterion = [](const auto& give) {
    BodySetup setup = fixtures::body_setup({.size = {0.02, 0.02, 0.006}, .poissons_ratio = 0.3});
    give(std::get<OrdinaryStateSetup>(setup.material));
    return *make_body(setup).failure;
  };
  const FailureCriterion by_stretch = criterion([](auto& m) { m.critical_stretch = 2e-3; });
  CHECK(by_stretch.layers == 6);
  CHECK(by_stretch.flexural_strength == fixtures::relative(2e-3 * E / (1 - 1.0 / 6), 1e-14));
  const FailureCriterion by_energy = criterion([&](auto& m) { m.fracture_energy = by_stretch.fracture_energy; });
  const FailureCriterion by_strength = criterion([&](auto& m) { m.flexural_strength = by_stretch.flexural_strength; });
  CHECK(by_energy.stretch == fixtures::relative(2e-3, 1e-14));
  CHECK(by_strength.stretch == fixtures::relative(2e-3, 1e-14));
  const FailureCriterion ten = criterion([&](auto& m) { m.flexural_strength = 1e6, m.layers = 10; });
  CHECK(ten.stretch == fixtures::relative(0.9e6 / E, 1e-14));
}

TEST_CASE("failure: compression breaks no bond, all at the critical stretch, or all at a compressive limit, as set") {
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::shaken}) {
    const auto options = [&](const FailureSetup& failure) {
      return BodyOptions{.size = {0.008, 0.006, 0.005}, .critical_stretch = 1e-3, .points = points, .failure = failure};
    };
    const std::size_t all = body(options({})).family.initial_bonds();
    CHECK(broken_at(-0.5, options({})) == 0);
    CHECK(broken_at(-0.9e-3, options(in_compression(CompressionFailure::symmetric))) == 0);
    CHECK(broken_at(-1.1e-3, options(in_compression(CompressionFailure::symmetric))) == all);
    CHECK(broken_at(1.1e-3, options(in_compression(CompressionFailure::symmetric))) == all);
    CHECK(broken_at(-1.9e-2, options(in_compression(CompressionFailure::limit, 2e-2))) == 0);
    CHECK(broken_at(-2.1e-2, options(in_compression(CompressionFailure::limit, 2e-2))) == all);
    CHECK(broken_at(1.1e-3, options(in_compression(CompressionFailure::limit, 2e-2))) == all);
  }
}

TEST_CASE("failure: with scatter a bond breaks at the mean strength of its two particles, at both ends, with the Weibull frequency") {
  for (const auto points : {fixtures::Points::lattice, fixtures::Points::shaken}) {
    FailureSetup failure;
    failure.weibull_modulus = 5.0, failure.seed = 3;
    const BodyOptions options{.critical_stretch = 1e-3, .points = points, .failure = failure};
    const double s = 1.02e-3;
    Body solid = body(options), intact = body(options);
    fixtures::deform(solid, [&](const Vec3d& X) { return (1 + s) * X; });
    solid.internal.evaluate(solid.particles, solid.family);
    std::size_t wrong = 0, bonds = 0;
    for (const std::uint32_t slot : solid.particles.slot_of()) {
      std::vector<bool> has(solid.particles.slots(), false);
      solid.family.for_each_bond(slot, [&](const FamilyBond& bond) { has[bond.j] = true; });
      intact.family.for_each_bond(slot, [&](const FamilyBond& bond) {
        const double k = 0.5 * (weibull_factor(5, 3, slot) + weibull_factor(5, 3, bond.j));
        ++bonds;
        if (std::fabs(k * 1e-3 - s) > 1e-12) wrong += has[bond.j] != (s < k * 1e-3);
      });
    }
    CHECK(wrong == 0);
    CHECK(solid.internal.broken_bonds() > bonds / 8);  // about half of the pairs: the mean of two factors has its median near 1
    CHECK(solid.internal.broken_bonds() < bonds / 2 * 3 / 4);
  }
}

TEST_CASE("failure: Weibull factors have mean 1 and the scatter of their modulus, and depend on the seed") {
  for (const double m : {2.0, 5.0, 20.0}) {
    double sum = 0, squares = 0;
    constexpr int count = 100'000;
    for (int n = 0; n < count; ++n) {
      const double k = weibull_factor(m, 1, static_cast<std::uint64_t>(n));
      sum += k, squares += k * k;
    }
    const double mean = sum / count, variance = squares / count - mean * mean;
    const double exact = std::tgamma(1 + 2 / m) / std::pow(std::tgamma(1 + 1 / m), 2) - 1;
    CHECK(mean == fixtures::relative(1, 4 * std::sqrt(exact / count)));  // four standard errors
    CHECK(variance == fixtures::relative(exact, 0.03));                  // standard error about 1 %
  }
  CHECK(weibull_factor(5, 1, 7) != weibull_factor(5, 2, 7));
}

TEST_CASE("failure: no_fail particles keep all their bonds at any stretch") {
  Body solid = body({.critical_stretch = 1e-3});
  std::vector<std::size_t> never;
  for (const std::uint32_t slot : solid.particles.slot_of())
    if (solid.particles.reference(slot).x < 0) never.push_back(slot);
  const std::vector<double> strength = strength_of({}, solid.particles, never);
  const OrdinaryStateForce& force = *solid.internal.ordinary_state();
  for (const std::optional<double> compression : {std::optional<double>(), std::optional<double>(1e-3)}) {
    Family family = solid.family;
    InternalForce internal(
        OrdinaryStateForce(force.law(), Breaking({1e-3, compression}, strength, family, solid.particles), force.correction(), family, solid.particles),
        solid.particles);
    for (const double s : {0.5, -0.5}) {
      fixtures::deform(solid, [&](const Vec3d& X) { return (1 + s) * X; });
      internal.evaluate(solid.particles, family);
    }
    std::size_t expected = 0;
    for (const std::uint32_t slot : solid.particles.slot_of())
      solid.family.for_each_bond(
          slot, [&](const FamilyBond& bond) { expected += solid.particles.reference(slot).x >= 0 && solid.particles.reference(bond.j).x >= 0; });
    CHECK(internal.broken_bonds() == expected / 2);
  }
}

namespace {

FailureSetup hardening(double alpha) {
  FailureSetup failure;
  failure.compression_hardening = alpha;
  return failure;
}

/// Broken bonds of a body compressed by ε along x, with free lateral expansion ν ε.
std::size_t broken_when_squeezed(double strain, double nu, const BodyOptions& options) {
  Body solid = body(options);
  fixtures::deform(solid, [&](const Vec3d& X) { return Vec3d{(1 - strain) * X.x, (1 + nu * strain) * X.y, (1 + nu * strain) * X.z}; });
  solid.internal.evaluate(solid.particles, solid.family);
  return solid.internal.broken_bonds();
}

}  // namespace

TEST_CASE("failure: with compression hardening uniform compression breaks lateral bonds at s_c/(ν - α), and none for α ≥ ν") {
  constexpr double stretch = 1e-3, nu = 0.25;
  for (const double alpha : {0.0, 0.1, 0.2}) {
    const BodyOptions options{.critical_stretch = stretch, .failure = hardening(alpha)};
    const double limit = stretch / (nu - alpha);
    CAPTURE(alpha);
    // lengths are exact to rounding; lateral bonds have the largest stretch, those along x the smallest
    CHECK(broken_when_squeezed((1 - 1e-6) * limit, nu, options) == 0);
    CHECK(broken_when_squeezed((1 + 1e-6) * limit, nu, options) > 0);
  }
  CHECK(broken_when_squeezed(0.5, nu, {.critical_stretch = stretch, .failure = hardening(0.25)}) == 0);
}

TEST_CASE("failure: compression hardening has no effect without compression") {
  constexpr double stretch = 1e-3;
  const BodyOptions options{.critical_stretch = stretch, .failure = hardening(0.2)};
  CHECK(broken_at((1 - 1e-9) * stretch, options) == 0);
  CHECK(broken_at((1 + 1e-9) * stretch, options) > 0);
}

TEST_CASE("failure: with compression hardening each bond breaks by the minimum stretches of its two particles, in pass after pass") {
  constexpr double stretch = 1e-3, alpha = 0.15;
  for (const auto points : {Points::lattice, Points::shaken})
    for (const bool scatters : {false, true}) {
      CAPTURE(scatters);
      FailureSetup failure = hardening(alpha);
      if (scatters) failure.weibull_modulus = 5.0, failure.seed = 3;
      Body solid = body({.critical_stretch = stretch, .points = points, .failure = failure});
      const Particles& particles = solid.particles;
      const auto strength = [&](std::size_t slot) { return scatters ? weibull_factor(5, 3, slot) : 1.0; };
      const auto stretch_of = [&](std::size_t slot, const FamilyBond& bond) {
        return norm(particles.position.at(bond.j) - particles.position.at(slot)) / bond.length - 1;
      };
      for (unsigned pass = 1; pass <= 6; ++pass) {  // some almost undeformed, so that compression is released
        fixtures::deform(solid, [](const Vec3d& X) { return X; });
        fixtures::shake(solid, pass % 3 == 0 ? 1e-9 : 6e-7 * pass, pass);
        std::vector<double> pressed(particles.slots(), 0.0);
        for (const std::uint32_t slot : particles.slot_of())
          solid.family.for_each_bond(slot, [&](const FamilyBond& bond) { pressed[slot] = fixtures::larger(pressed[slot], -stretch_of(slot, bond)); });
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, left;
        std::size_t hardened = 0;
        for (const std::uint32_t slot : particles.slot_of())
          solid.family.for_each_bond(slot, [&](const FamilyBond& bond) {
            const double s = stretch_of(slot, bond), rest = 0.5 * stretch * (strength(slot) + strength(bond.j));
            const double limit = rest + 0.5 * alpha * (pressed[slot] + pressed[bond.j]);
            if (s <= limit) expected.emplace_back(slot, bond.j);
            hardened += s > rest && s <= limit;
          });
        solid.internal.evaluate(solid.particles, solid.family);
        for (const std::uint32_t slot : particles.slot_of()) solid.family.for_each_bond(slot, [&](const FamilyBond& bond) { left.emplace_back(slot, bond.j); });
        CHECK(left == expected);
        CHECK((hardened > 50) == (pass % 3 != 0));  // the test discriminates
      }
      CHECK(solid.internal.broken_bonds() > 100);
    }
}

TEST_CASE("failure: with compression hardening forces and energies do not depend on the compression in the previous pass") {
  const auto shaken = [](Body& solid, double by) {
    fixtures::deform(solid, [](const Vec3d& X) { return X; });
    fixtures::shake(solid, by, 7);
  };
  Body fresh = body({.critical_stretch = 1e-3, .failure = hardening(0.15)}), used = body({.critical_stretch = 1e-3, .failure = hardening(0.15)});
  shaken(used, 3e-7);  // presses some, and breaks none
  used.internal.evaluate(used.particles, used.family);
  REQUIRE(used.internal.broken_bonds() == 0);
  for (Body* solid : {&fresh, &used}) shaken(*solid, 1e-6);
  CHECK(fresh.internal.evaluate_with_energy(fresh.particles, fresh.family) == used.internal.evaluate_with_energy(used.particles, used.family));
  CHECK(fresh.internal.broken_bonds() > 0);
  CHECK(fresh.internal.broken_bonds() == used.internal.broken_bonds());
  for (const std::uint32_t slot : fresh.particles.slot_of()) REQUIRE(fresh.particles.force_density.at(slot) == used.particles.force_density.at(slot));
}

TEST_CASE("failure: compression hardening breaks the same bonds on a lattice, in lists, and one particle at a time") {
  const auto broken = [](Points points, bool one_at_a_time) {
    Body solid = body({.critical_stretch = 1e-3, .points = points, .failure = hardening(0.15)});
    fixtures::shake(solid, 2e-6);
    if (one_at_a_time)
      solid.internal.evaluate_scalar(solid.particles, solid.family);
    else
      solid.internal.evaluate(solid.particles, solid.family);
    return solid.internal.broken_bonds();
  };
  const std::size_t lattice = broken(Points::lattice, false);
  CHECK(lattice > 100);
  CHECK(broken(Points::lattice, true) == lattice);
  CHECK(broken(Points::listed, false) == lattice);
}
