#include "io/statistics/spectrum.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

std::vector<double> white(std::size_t count, double deviation, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, deviation);
  std::vector<double> values(count);
  for (double& value : values) value = normal(random);
  return values;
}

double power_of(const Spectrum& spectrum) { return std::accumulate(spectrum.density.begin(), spectrum.density.end(), 0.0) * spectrum.resolution(); }

}  // namespace

TEST_CASE("spectrum: the fast transform equals its defining sum") {
  for (const std::size_t N : {1u, 2u, 4u, 8u, 64u, 256u}) {
    const std::vector<double> re = white(N, 1, 1), im = white(N, 1, 2);
    std::vector<std::complex<double>> x(N);
    for (std::size_t n = 0; n < N; ++n) x[n] = {re[n], im[n]};
    std::vector<std::complex<double>> fast = x;
    fourier_transform(fast);
    for (std::size_t k = 0; k < N; ++k) {
      std::complex<double> sum = 0;
      for (std::size_t n = 0; n < N; ++n) sum += x[n] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k * n % N) / static_cast<double>(N));
      CHECK(std::abs(fast[k] - sum) < 1e-12 * std::sqrt(static_cast<double>(N)) * static_cast<double>(N));  // rounding of N numbers of size 1
    }
  }
}

TEST_CASE("spectrum: its integral is the mean square of the windowed segment divided by that of the window (Parseval)") {
  const std::size_t N = 1024;
  std::vector<double> values = white(N, 2, 3);
  for (double& value : values) value += 7;
  const Spectrum spectrum = welch(values, 0.02, N);
  CHECK(spectrum.segments == 1);
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(N);
  double square = 0, window_square = 0;
  for (std::size_t n = 0; n < N; ++n) {
    const double w = std::pow(std::sin(std::numbers::pi * static_cast<double>(n) / static_cast<double>(N)), 2);
    square += w * w * (values[n] - mean) * (values[n] - mean);
    window_square += w * w;
  }
  CHECK(power_of(spectrum) == fixtures::relative(square / window_square, 1e-12));  // rounding
}

TEST_CASE("spectrum: a sine has its peak at its frequency, with half the square of its amplitude") {
  const double interval = 0.01, amplitude = 3;
  const std::size_t N = 8192, segment = 1024;
  for (const std::size_t bin : {5u, 60u, 400u}) {
    const double frequency = static_cast<double>(bin) / (interval * static_cast<double>(segment));
    std::vector<double> values(N);
    for (std::size_t n = 0; n < N; ++n) values[n] = 100 + amplitude * std::sin(2 * std::numbers::pi * frequency * interval * static_cast<double>(n) + 0.4);
    const Spectrum spectrum = welch(values, interval, segment);
    CHECK(spectrum.segments == 15);
    CHECK(spectrum.highest() == bin);
    CHECK(spectrum.frequency(bin) == fixtures::relative(frequency, 1e-12));
    CHECK(power_of(spectrum) == fixtures::relative(amplitude * amplitude / 2, 1e-9));  // whole periods: rounding
    // all power is in the three bins of the Hann window
    double near = 0;
    for (std::size_t k = bin - 1; k <= bin + 1; ++k) near += spectrum.density[k] * spectrum.resolution();
    CHECK(near == fixtures::relative(amplitude * amplitude / 2, 1e-9));
  }
}

TEST_CASE("spectrum: a sine between two bins peaks at one of them") {
  const double frequency = 1.237;
  std::vector<double> values(4096);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = std::sin(2 * std::numbers::pi * frequency * 0.05 * static_cast<double>(n));
  const Spectrum spectrum = welch(values, 0.05, 512);
  CHECK(std::abs(spectrum.frequency(spectrum.highest()) - frequency) < spectrum.resolution());
}

TEST_CASE("spectrum: white noise has the density 2 dt times its variance at every frequency") {
  const double interval = 0.004, deviation = 5;
  const Spectrum spectrum = welch(white(std::size_t{1} << 18, deviation, 4), interval, 256);
  const double level = 2 * interval * deviation * deviation;
  // 2047 half-overlapping segments: about 1500 independent ones, so 1/sqrt(1500) = 2.6 % per bin; chance deviations stay below 6 times that
  for (std::size_t k = 2; k < 128; ++k) CHECK(spectrum.density[k] == fixtures::relative(level, 0.16));
  // the sum over 126 bins scatters by 0.3 %
  CHECK(std::accumulate(spectrum.density.begin() + 2, spectrum.density.begin() + 128, 0.0) / 126 == fixtures::relative(level, 0.015));
}

TEST_CASE("spectrum: a constant has zero density and no dominant frequency") {
  const Spectrum spectrum = welch(std::vector<double>(1000, 4.0), 0.1, 128);
  for (const double density : spectrum.density) CHECK(density == 0);  // 128 fours sum and divide exactly
  CHECK(spectrum.highest() == 0);
}

TEST_CASE("spectrum: the default segment is a power of two that fits, seven times where the record is long enough") {
  CHECK(default_segment(16) == 16);
  CHECK(default_segment(100) == 32);
  CHECK(default_segment(127) == 32);
  CHECK(default_segment(1000) == 128);
  CHECK(default_segment(1024) == 256);
  for (std::size_t values = 128; values < 3000; values += 7) {
    const std::size_t segment = default_segment(values);
    CHECK((values - segment) / (segment / 2) + 1 >= 7);
  }
}
