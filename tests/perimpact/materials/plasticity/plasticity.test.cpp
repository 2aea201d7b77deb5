#include "perimpact/materials/plasticity/plasticity.hpp"

#include <doctest/doctest.h>

#include <random>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

constexpr YieldSurface every_surface[] = {YieldSurface::riska_frederking, YieldSurface::derradji_aouat, YieldSurface::kierkegaard, YieldSurface::von_mises};

/// f of uniaxial compression with this stress [Pa].
double uniaxial(const YieldEllipse& ellipse, double stress) { return ellipse.function({-stress, 0, 0, 0, 0, 0}); }

/// C : ε of a cubic material, written out with C11, C12 and C44.
SymmetricTensor stress_of(const ReturnModuli& moduli, const SymmetricTensor& e) {
  const double c12 = moduli.bulk - 2 * moduli.axial_shear / 3, c11 = c12 + 2 * moduli.axial_shear, trace = e[0] + e[1] + e[2];
  SymmetricTensor stress;
  for (std::size_t c = 0; c < 3; ++c) stress[c] = (c11 - c12) * e[c] + c12 * trace;
  for (std::size_t c = 3; c < 6; ++c) stress[c] = 2 * moduli.plane_shear * e[c];
  return stress;
}

}  // namespace

TEST_CASE("plasticity: the uniaxial strength of a surface is where uniaxial compression reaches it, and scaling gives any other") {
  const double published[] = {4.43e6, 9.35e6, 9.00e6, 1};  // to 0.01 MPa
  for (const YieldSurface surface : every_surface) {
    const YieldEllipse ellipse = YieldEllipse::published(surface);
    CHECK(ellipse.compressive_strength() == fixtures::relative(published[static_cast<int>(surface)], 0.002));
    for (const YieldEllipse& one : {ellipse, YieldEllipse::of_strength(surface, 2.3e6)}) {
      const double strength = one.compressive_strength();
      CHECK(uniaxial(one, strength * (1 + 1e-9)) > 0);
      CHECK(uniaxial(one, strength * (1 - 1e-9)) < 0);
    }
    CHECK(YieldEllipse::of_strength(surface, 2.3e6).compressive_strength() == fixtures::relative(2.3e6, 1e-12));
  }
  // Riska and Frederking: the ellipse closes at 7.23 MPa, and uniaxial tension would reach it at 0.90 MPa
  const YieldEllipse ice = YieldEllipse::published(YieldSurface::riska_frederking);
  CHECK(ice.largest_pressure() == fixtures::relative(7.23e6, 0.001));
  CHECK(ice.limit(ice.largest_pressure()) == fixtures::absolute(0, 1e-12 * ice.a0, "Pa2"));
  CHECK(uniaxial(ice, -0.89e6) < 0);
  CHECK(uniaxial(ice, -0.91e6) > 0);
}

TEST_CASE("plasticity: the return ends on the surface, by an elastic release along the normals of the surface") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (const YieldSurface surface : every_surface)
    for (const ReturnModuli& moduli : {ReturnModuli{1.2e9, 0.72e9, 0.72e9}, ReturnModuli{1.17e9, 0.62e9, 0.76e9}}) {
      const YieldEllipse ellipse = YieldEllipse::of_strength(surface, 2.3e6);
      int returned = 0;
      for (int n = 0; n < 200; ++n) {
        SymmetricTensor trial;
        for (double& component : trial) component = 3e6 * draw(random);
        for (std::size_t c = 0; c < 3; ++c) trial[c] -= 2e6 * (1 + draw(random));
        if (pressure_of(trial) <= 0 || ellipse.function(trial) <= 0) continue;
        ++returned;
        SymmetricTensor stress = trial;
        const SymmetricTensor strain = return_to_surface(ellipse, moduli, stress);
        const double scale = second_invariant(trial) + ellipse.a0;
        CHECK(ellipse.function(stress) <= 1e-9 * scale);
        CHECK(ellipse.function(stress) >= -1e-2 * scale);  // Newton's steps on a convex function end outside or, where J2 goes to 0, a little inside
        const SymmetricTensor released = stress_of(moduli, strain);
        for (std::size_t c = 0; c < 6; ++c) CHECK(trial[c] - released[c] == fixtures::absolute(stress[c], 1e-9 * 1e7, "Pa"));
        CHECK(double_contraction(stress, strain) > 0);  // flow dissipates
        CHECK(double_contraction(trial, strain) > 0);
      }
      CHECK(returned > 20);
    }
}

TEST_CASE("plasticity: a small excess flows along the gradient of the surface") {
  const YieldEllipse ellipse = YieldEllipse::of_strength(YieldSurface::riska_frederking, 2.3e6);
  const ReturnModuli moduli{1.2e9, 0.72e9, 0.72e9};
  SymmetricTensor stress{-2.31e6, -0.02e6, 0.01e6, 0.05e6, -0.02e6, 0.03e6};
  REQUIRE(ellipse.function(stress) > 0);
  SymmetricTensor at = stress, gradient;
  for (std::size_t c = 0; c < 6; ++c) {
    const double h = 10;  // of a quadratic function: rounding alone, 1e-16 × 1e12/10
    SymmetricTensor above = stress, below = stress;
    above[c] += h, below[c] -= h;
    gradient[c] = (ellipse.function(above) - ellipse.function(below)) / (2 * h) / (c < 3 ? 1 : 2);  // σ_xy and σ_yx
  }
  const SymmetricTensor strain = return_to_surface(ellipse, moduli, at);
  const double size = std::sqrt(double_contraction(strain, strain) / double_contraction(gradient, gradient));
  for (std::size_t c = 0; c < 6; ++c)  // the direction turns by as much as the stress changes, 1 %
    CHECK(strain[c] / size == fixtures::absolute(gradient[c], 0.02 * std::sqrt(double_contraction(gradient, gradient)), "Pa"));
}

TEST_CASE("plasticity: the failure strain is least at its pressure and grows with the square of the distance from it") {
  const FailureStrain failure;
  CHECK(failure.at(0.75) == fixtures::relative(0.01, 1e-12));
  CHECK(failure.at(0) == fixtures::relative(0.01 + 0.5625, 1e-12));
  CHECK(FailureStrain{.least = 0.02, .width = 2, .pressure = 0.5}.at(0.9) == fixtures::relative(0.02 + 0.04, 1e-12));
}

TEST_CASE(
    "plasticity: ice without cohesion returns to the cone of its friction angle at unchanged pressure and volume, or to the ellipse where that is lower") {
  // φ = 30 degrees: q/p = 1.2 (triaxial compression, Mohr-Coulomb: σ1/σ3 = 3, so q = 2 σ3 and p = 5/3 σ3)
  const double residual = residual_of_friction_angle(std::acos(-1.0) / 6);
  CHECK(3 * residual == fixtures::relative(1.2 * 1.2, 1e-12));
  const YieldEllipse ellipse = YieldEllipse::of_strength(YieldSurface::riska_frederking, 2.3e6);
  const ReturnModuli moduli{1.17e9, 0.62e9, 0.76e9};
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> draw(-1, 1);
  int to_cone = 0, to_ellipse = 0;
  for (int n = 0; n < 400; ++n) {
    SymmetricTensor trial;
    for (double& component : trial) component = 3e6 * draw(random);
    const double pressure = 2e6 * (1 + draw(random));
    for (std::size_t c = 0; c < 3; ++c) trial[c] -= pressure;
    const double p = pressure_of(trial);
    if (p <= 0 || second_invariant(trial) <= residual * p * p) continue;
    SymmetricTensor stress = trial;
    const SymmetricTensor strain = return_to_residual(ellipse, residual, moduli, stress);
    const SymmetricTensor released = stress_of(moduli, strain);
    for (std::size_t c = 0; c < 6; ++c) CHECK(trial[c] - stress[c] == fixtures::absolute(released[c], 1e-3, "Pa"));
    CHECK(double_contraction(stress, strain) >= 0);
    if (residual * p * p < ellipse.limit(p)) {
      ++to_cone;
      CHECK(second_invariant(stress) == fixtures::relative(residual * p * p, 1e-12));
      CHECK(pressure_of(stress) == fixtures::relative(p, 1e-12));
      CHECK(strain[0] + strain[1] + strain[2] == fixtures::absolute(0, 1e-15, "-"));
    } else {
      ++to_ellipse;
      CHECK(ellipse.function(stress) == fixtures::absolute(0, 1e-9 * ellipse.a0, "Pa2"));
    }
  }
  CHECK(to_cone > 50);
  CHECK(to_ellipse > 20);
}
