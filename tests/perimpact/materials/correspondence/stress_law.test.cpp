#include "perimpact/materials/correspondence/stress_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "base/pack.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"
#include "perimpact/small_matrices.hpp"

using namespace perimpact;
using fccda::Mat3;

namespace {

template <std::size_t D>
using Matrix = SmallMatrix<double, D>;

constexpr double lambda = 1.2, mu = 0.7;  // [Pa]

template <std::size_t D>
Stress<double, D> stress(StressLaw law, const Matrix<D>& x) {
  return law == StressLaw::hencky ? hencky_stress(x, lambda, mu) : st_venant_kirchhoff(x, lambda, mu);
}

/// C - 1 of a random deformation whose gradient differs from 1 by up to `size`.
template <std::size_t D>
Matrix<D> random_strain(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  Matrix<D> g;
  for (auto& row : g.m)
    for (double& element : row) element = number(random);
  return scaled_sum(1.0, transpose(g) * g, scaled_sum(1.0, transpose(g), g));
}

template <std::size_t D>
void check_gradient(StressLaw law, double size, unsigned seed) {
  std::mt19937_64 random(seed);
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix<D> x = random_strain<D>(random, size);
    const Stress<double, D> at = stress(law, x);
    double scale = 1;
    for (const auto& row : at.second.m)
      for (const double element : row) scale = fixtures::larger(scale, std::fabs(element));
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s) {
        const double h = 1e-6;
        Matrix<D> above = x, below = x;
        above.m[r][s] += 0.5 * h, above.m[s][r] += 0.5 * h;
        below.m[r][s] -= 0.5 * h, below.m[s][r] -= 0.5 * h;
        // error h² by the difference, and 1e-16/h by rounding, both below 1e-9 of the largest
        CHECK(2 * (stress(law, above).energy - stress(law, below).energy) / (2 * h) == fixtures::absolute(at.second.m[r][s], 1e-8 * scale, "Pa"));
      }
  }
}

}  // namespace

TEST_CASE("stress laws: the stress is twice the derivative of the energy with respect to C, for small and large strains") {
  for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff})
    for (const double size : {0.01, 0.4}) {  // by the series, by eigenvalues
      CAPTURE(size);
      check_gradient<3>(law, size, 1);
      check_gradient<2>(law, size, 2);
    }
}

TEST_CASE("stress laws: the energy is quadratic in the principal strains of the law") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Matrix<3> x = random_strain<3>(random, trial < 25 ? 0.02 : 0.3);
    Mat3 c;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = 0; s < 3; ++s) c.row[r][s] = x.m[r][s] + (r == s);
    double ln_volume = 0, ln_squares = 0, green_volume = 0, green_squares = 0;
    for (const double value : fixtures::eigenvalues_of(c)) {
      const double ln = 0.5 * std::log(value), green = 0.5 * (value - 1);
      ln_volume += ln, ln_squares += ln * ln, green_volume += green, green_squares += green * green;
    }
    // eigenvalues of the reference, from a cubic, are accurate to 1e-9 where two are nearly equal
    CHECK(stress(StressLaw::hencky, x).energy == fixtures::relative(0.5 * lambda * ln_volume * ln_volume + mu * ln_squares, 1e-9));
    CHECK(stress(StressLaw::st_venant_kirchhoff, x).energy == fixtures::relative(0.5 * lambda * green_volume * green_volume + mu * green_squares, 1e-9));
  }
}

TEST_CASE("stress laws: the logarithm by series and by eigenvalues agree at the transition") {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    Matrix<3> x = random_strain<3>(random, 0.1);
    const double size = std::sqrt(hencky::largest_square / contraction(x, x));
    for (auto& row : x.m)
      for (double& element : row) element *= size;
    const auto series = hencky::by_series(x, lambda, mu), exact = hencky::by_eigenvalues(x, lambda, mu);
    // the first neglected term is 4e-17 of the strain; eigenvalues are accurate to 1e-16 of the largest, 0.1
    CHECK(series.energy == fixtures::relative(exact.energy, 1e-14));
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = 0; s < 3; ++s) CHECK(std::fabs(series.second.m[r][s] - exact.second.m[r][s]) < 1e-15);
  }
}

TEST_CASE("stress laws: particles of a pack have the same stress as single ones, with the logarithm by series or by eigenvalues") {
  using Pack = fccda::NativePack;
  constexpr std::size_t width = fccda::lanes<Pack>;
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Matrix<3> x[width];
    SmallMatrix<Pack, 3> packed;
    for (std::size_t lane = 0; lane < width; ++lane) x[lane] = random_strain<3>(random, lane % 2 ? 0.2 : 0.01);
    double lanes_of[width];
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t lane = 0; lane < width; ++lane) lanes_of[lane] = x[lane].m[r][s];
        packed.m[r][s] = fccda::load<Pack>(lanes_of);
      }
    const Stress<Pack, 3> all = hencky_stress(packed, lambda, mu);
    for (std::size_t lane = 0; lane < width; ++lane) {
      const Stress<double, 3> alone = hencky_stress(x[lane], lambda, mu);
      fccda::store(lanes_of, all.energy);
      CHECK(lanes_of[lane] == alone.energy);
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t s = 0; s < 3; ++s) {
          fccda::store(lanes_of, all.second.m[r][s]);
          CHECK(lanes_of[lane] == alone.second.m[r][s]);
        }
    }
  }
}

TEST_CASE("stress laws: flattened or inverted states have a finite stress, the derivative of a finite energy") {
  for (const double c : {0.02, 0.011, 0.01, 0.009, 0.0, -1e-9}) {
    CAPTURE(c);
    const auto of = [](double zz) {
      Matrix<3> x;
      x.m[2][2] = zz - 1;
      return hencky_stress(x, lambda, mu);
    };
    const double h = 1e-7, slope = 2 * (of(c + h).energy - of(c - h).energy) / (2 * h);
    CHECK(slope == fixtures::relative(of(c).second.m[2][2], 1e-4));  // at 0.01 the second derivative jumps: h/0.01 of the slope
    CHECK(std::isfinite(of(c).energy));
  }
}

TEST_CASE("stress laws: plane stress is the two-dimensional law with the plane-stress constants") {
  const IsotropicElastic solid{2.0, 0.3}, plane = IsotropicElastic::in(Plane::stress, 2.0, 0.3);
  std::mt19937_64 random(6);
  for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff})
    for (int trial = 0; trial < 20; ++trial) {
      const Matrix<2> x = random_strain<2>(random, 0.2);
      Matrix<3> in_space;
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t s = 0; s < 2; ++s) in_space.m[r][s] = x.m[r][s];
      const auto of = [&](const auto& strain, const IsotropicElastic& elastic) {
        return law == StressLaw::hencky ? hencky_stress(strain, elastic.lame_modulus(), elastic.shear_modulus())
                                        : st_venant_kirchhoff(strain, elastic.lame_modulus(), elastic.shear_modulus());
      };
      double low = -0.9, high = 2;  // C_zz - 1 at which no stress acts across the plane
      for (int halving = 0; halving < 60; ++halving) {
        in_space.m[2][2] = 0.5 * (low + high);
        (of(in_space, solid).second.m[2][2] > 0 ? high : low) = in_space.m[2][2];
      }
      const auto wanted = of(in_space, solid);
      const auto found = of(x, plane);
      CHECK(found.energy == fixtures::relative(wanted.energy, 1e-12));  // the bisection ends at 1e-16
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t s = 0; s < 2; ++s) CHECK(found.second.m[r][s] == fixtures::absolute(wanted.second.m[r][s], 1e-12, "Pa"));
    }
}
