#include "fccda/rigid_body/piecewise_linear.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

PiecewiseLinear ramp() { return PiecewiseLinear({1, 2, 4, 4.5}, {0, 3, -1, 5}); }

/// Mean by the midpoint rule over many pieces: shares nothing with the table but at().
double summed_mean(const PiecewiseLinear& table, double t0, double t1) {
  constexpr int pieces = 20'000;
  double sum = 0;
  for (int k = 0; k < pieces; ++k) sum += table.at(t0 + (t1 - t0) * (k + 0.5) / pieces);
  return sum / pieces;
}

}  // namespace

TEST_CASE("piecewise linear function: values are linear between the points and constant beyond both ends") {
  const PiecewiseLinear table = ramp();
  CHECK(table.at(-7) == 0);
  CHECK(table.at(1) == 0);
  CHECK(table.at(1.5) == 1.5);
  CHECK(table.at(3) == 1);
  CHECK(table.at(4.25) == 2);
  CHECK(table.at(1e9) == 5);
}

TEST_CASE("piecewise linear function: the mean over any interval is the integral over its length") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(0, 5.5);
  const PiecewiseLinear table = ramp();
  for (int trial = 0; trial < 50; ++trial) {
    const double a = any(random), b = any(random), t0 = std::min(a, b), t1 = std::max(a, b);
    // the midpoint rule has an error only in the pieces with a kink: a step of slope 14 over a piece of 5.5/20000 s, 8e-8 of the interval each
    CHECK(std::fabs(table.mean(t0, t1) - summed_mean(table, t0, t1)) < 1e-6);
    CHECK(std::fabs(table.slope(t0, t1) * (t1 - t0) - (table.at(t1) - table.at(t0))) < 50 * eps);  // a few roundings of numbers up to 5
  }
}

TEST_CASE("piecewise linear function: a constant is exact, and an interval of zero length gives the value and the slope just after") {
  const PiecewiseLinear constant({0, 1, 2}, {0.3, 0.3, 0.3});
  for (double t = -0.5; t < 2; t += 0.1) CHECK(constant.mean(t, t + 0.07) == fixtures::relative(0.3, 2 * eps));
  CHECK(PiecewiseLinear(0.1).mean(3, 4) == 0.1);
  CHECK(ramp().mean(3, 3) == 1);
  CHECK(ramp().slope(2, 2) == -2);
  CHECK(ramp().slope(1, 1) == 3);
  CHECK(ramp().slope(5, 5) == 0);
}

TEST_CASE("piecewise linear function: the slope of a large value over a short time loses no digits") {
  const PiecewiseLinear table({0, 1}, {1e6, 1e6 + 1});
  CHECK(table.slope(0.5, 0.5 + 1e-9) == 1);  // the difference of the values has three digits
}

TEST_CASE("piecewise linear function: lists of different length, arguments that do not increase and values that are not numbers are rejected") {
  CHECK_THROWS_WITH_AS(PiecewiseLinear({}, {}), "table: there are no points; give at least one.", InputError);
  CHECK_THROWS_WITH_AS(PiecewiseLinear({0, 1}, {0}), "table: there are 2 arguments and 1 values, but each argument needs one value.", InputError);
  CHECK_THROWS_WITH_AS(PiecewiseLinear({0, 1, 1}, {0, 1, 2}), doctest::Contains("point 3 is at 1.000000, after one at 1.000000, but arguments must increase"),
                       InputError);
  CHECK_THROWS_AS(PiecewiseLinear({0, 1}, {0, std::nan("")}), InputError);
  CHECK_THROWS_AS(PiecewiseLinear({0, INFINITY}, {0, 1}), InputError);
}
