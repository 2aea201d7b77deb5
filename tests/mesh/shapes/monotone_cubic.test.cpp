#include "mesh/shapes/monotone_cubic.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "fixtures/tolerance.hpp"

using fccda::MonotoneCubic;

TEST_CASE("monotone cubic: it interpolates its points, stays between neighbours and has no kinks") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> x{0}, y{any(random)};
    for (std::size_t k = 0; k < 2 + random() % 8; ++k) x.push_back(x.back() + 0.05 + any(random)), y.push_back(random() % 4 ? any(random) : y.back());
    const MonotoneCubic curve(x, y);
    for (std::size_t k = 0; k < x.size(); ++k) CHECK(curve(x[k]) == fixtures::relative(y[k], 1e-14));  // rounding
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      double before = y[k];
      for (int i = 1; i <= 50; ++i) {
        const double now = curve(x[k] + (x[k + 1] - x[k]) * i / 50);
        CHECK((now - before) * (y[k + 1] - y[k]) >= -1e-14);  // monotone between two points, up to rounding
        before = now;
      }
    }
    constexpr double h = 1e-6;
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
      const double left = (y[k] - curve(x[k] - h)) / h, right = (curve(x[k] + h) - y[k]) / h;
      CHECK(left == fixtures::absolute(right, 1e-3, "1"));  // differences over h of curvatures below 1e3
    }
  }
}

TEST_CASE("monotone cubic: straight lines stay straight, and the value is constant beyond the ends") {
  const MonotoneCubic line({1, 2, 4, 5}, {3, 5, 9, 11});
  for (const double x : {1.0, 1.3, 2.0, 3.7, 5.0}) CHECK(line(x) == fixtures::relative(1 + 2 * x, 1e-14));  // rounding
  CHECK(line(0) == 3);
  CHECK(line(7) == 11);
  const MonotoneCubic two({0, 2}, {1, 0});
  CHECK(two(0.5) == fixtures::relative(0.75, 1e-14));
}

TEST_CASE("monotone cubic: agrees with another program on the squared chords of the Wageningen series") {
  // scipy.interpolate.PchipInterpolator of the same nine points
  const MonotoneCubic curve({0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}, {2.762244, 3.541924, 4.2025, 4.631104, 4.782969, 4.596736, 3.8809, 2.502724, 0});
  CHECK(curve(0.25) == fixtures::relative(3.16758759207252, 1e-12));
  CHECK(curve(0.63) == fixtures::relative(4.76136358460124, 1e-12));
  CHECK(curve(0.97) == fixtures::relative(0.8791591524908089, 1e-12));
}
