#include "base/logarithm.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "fixtures/larger.hpp"

TEST_CASE("logarithm: ln(1 + x) is within 5e-16 of that in extended precision, for small and large numbers, and where its parts meet") {
  const auto error = [](double x) {
    const long double exact = std::log1p(static_cast<long double>(x));
    return x == 0 ? 0.0 : static_cast<double>(std::fabs((fccda::log_of_one_plus(x) - exact) / exact));
  };
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-40, 40), share(0, 1);
  double most = 0;
  for (int n = 0; n < 100000; ++n) {
    const double x = std::exp2(exponent(random)), below = -share(random);
    for (const double each : {x, below, -x < -0.999 ? below : -x}) most = fixtures::larger(most, error(each));
  }
  constexpr double root = 1.4142135623730951;
  for (const double edge : {root - 1, 0.5 * root - 1, 1.0, -0.5, 3.0, root * 2 - 1, -0.75})
    for (const double step : {-1.0, 0.0, 1.0}) most = fixtures::larger(most, error(edge + step * 1e-15));
  CHECK(most < 5e-16);
  CHECK(most > 1e-17);  // it is compared
}

TEST_CASE("logarithm: of 1 it is 0, and of what is not finite that itself") {
  CHECK(fccda::log_of_one_plus(0.0) == 0);
  CHECK(std::isnan(fccda::log_of_one_plus(std::numeric_limits<double>::quiet_NaN())));
  CHECK(fccda::log_of_one_plus(std::numeric_limits<double>::infinity()) == std::numeric_limits<double>::infinity());
  CHECK(std::isfinite(fccda::log_of_one_plus(-1 + std::numeric_limits<double>::epsilon())));
}
