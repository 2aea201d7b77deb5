/// Compression of numbers for the browser: reals are quantised to integers, integers are stored as prediction residuals in byte planes, then gzip
/// and base64. docs/guide/report.md specifies the format for other readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact::report {

/// Uniform quantisation of the range from `low` to `high`: value = low + step · number, with integers from 0 and an error of at most half a step.
class Scale {
 public:
  Scale() = default;
  Scale(double low, double high, std::uint32_t steps);

  double low() const { return low_; }
  double high() const { return low_ + step_ * largest_; }
  double step() const { return step_; }  ///< 0 where all values are `low`
  std::uint32_t number_of(double value) const;

 private:
  double low_ = 0, step_ = 0;
  std::uint32_t largest_ = 0;
};

/// Encodes one array frame by frame. For each frame it uses the prediction, of six, with the smallest residuals:
///
///   0  zero                                      3  residual of the previous element under prediction 0
///   1  the previous frame                        4  the same under 1
///   2  linear extrapolation of the two previous  5  the same under 2
///
/// Residuals (modulo 2^bits) are zigzag-coded, 0 −1 1 −2 … → 0 1 2 3 …, and written as byte planes: all lowest bytes first.
class ArrayPacker {
 public:
  /// `bytes` of each number: 1, 2 or 4.
  explicit ArrayPacker(int bytes) : bytes_(bytes) {}

  /// Appends the number of the prediction (one byte) and the byte planes.
  void append(std::span<const std::uint32_t> numbers, std::string& out);

 private:
  int bytes_;
  std::vector<std::uint32_t> before_, before_that_;  // the last two frames
};

/// A gzip file in memory (RFC 1952); deterministic.
std::string gzip(std::string_view bytes);

/// RFC 4648, section 4, on one line.
std::string base64(std::string_view bytes);

}  // namespace perimpact::report
