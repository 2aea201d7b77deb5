#include "io/statistics/spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/contract.hpp"

namespace perimpact {

void fourier_transform(std::span<std::complex<double>> x) {
  const std::size_t N = x.size();
  EXPECTS(std::has_single_bit(N));
  for (std::size_t i = 1, j = 0; i < N; ++i) {  // bit-reversal permutation
    std::size_t bit = N >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  std::vector<std::complex<double>> turn(N / 2);
  for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(N));
  for (std::size_t half = 1; half < N; half *= 2)
    for (std::size_t begin = 0; begin < N; begin += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        const std::complex<double> even = x[begin + k], odd = turn[k * (N / (2 * half))] * x[begin + half + k];
        x[begin + k] = even + odd;
        x[begin + half + k] = even - odd;
      }
}

std::size_t Spectrum::highest() const {
  std::size_t highest = 0;
  for (std::size_t k = 1; k < density.size(); ++k)
    if (density[k] > (highest == 0 ? 0 : density[highest])) highest = k;
  return highest;
}

Spectrum welch(std::span<const double> values, double interval, std::size_t segment) {
  EXPECTS(std::has_single_bit(segment) && segment >= 4 && segment <= values.size());
  const std::size_t shift = segment / 2, segments = (values.size() - segment) / shift + 1;
  std::vector<double> window(segment);
  for (std::size_t n = 0; n < segment; ++n) window[n] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(segment));
  const double power = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);

  Spectrum spectrum{.interval = interval, .segment = segment, .segments = segments, .density = std::vector<double>(segment / 2 + 1, 0.0)};
  std::vector<std::complex<double>> x(segment);
  for (std::size_t s = 0; s < segments; ++s) {
    const std::span<const double> part = values.subspan(s * shift, segment);
    const double mean = std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(segment);
    for (std::size_t n = 0; n < segment; ++n) x[n] = window[n] * (part[n] - mean);
    fourier_transform(x);
    for (std::size_t k = 0; k <= segment / 2; ++k) {
      const double sides = k == 0 || k == segment / 2 ? 1 : 2;
      spectrum.density[k] += sides * interval * std::norm(x[k]) / (power * static_cast<double>(segments));
    }
  }
  return spectrum;
}

std::size_t default_segment(std::size_t values) {
  constexpr std::size_t least = 32;
  const std::size_t of_seven = std::bit_floor(values / 4);  // seven half-overlapping segments span (7 + 1)/2 segments
  return std::min(std::max(of_seven, least), std::bit_floor(values));
}

}  // namespace perimpact
