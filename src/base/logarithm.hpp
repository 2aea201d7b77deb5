/// Natural logarithm from operations that every processor and GPU rounds alike, for results that are bitwise the same on all of them.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "base/host_device.hpp"

namespace fccda {

/// ln(1 + x) with a relative error below 5e-16, for x from -1 + 2⁻⁵³ on. NaN and infinity are returned as they are.
///
/// 1 + x = 2ᵏ (1 + f) with √½ < 1 + f < √2, and ln(1 + f) = 2 artanh(f/(2 + f)) by its series.
FCCDA_HD inline double log_of_one_plus(double x) {
  constexpr double root_two = 1.4142135623730951, ln_two = 0.6931471805599453;
  if (!(x < std::numeric_limits<double>::infinity())) return x;
  double f = x, powers = 0;
  if (const double sum = 1 + x; !(sum > 0.5 * root_two && sum < root_two)) {
    constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1;
    const auto bits = std::bit_cast<std::uint64_t>(sum);
    double reduced = std::bit_cast<double>((bits & mantissa) | std::bit_cast<std::uint64_t>(1.0));
    powers = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
    if (reduced > root_two) reduced *= 0.5, powers += 1;
    f = reduced - 1;
  }
  const double s = f / (2 + f), square = s * s;
  double series = 1.0 / 21;  // s² < 0.0295: the next term is 1e-18 of the sum
  for (int n = 19; n >= 3; n -= 2) series = series * square + 1.0 / n;
  return powers * ln_two + (2 * s + 2 * s * (square * series));
}

}  // namespace fccda
