/// How numbers are packed for the browser: reals as whole numbers of a step, whole numbers as what a prediction leaves, in planes of bytes,
/// as gzip, as base64. docs/guide/report.md describes the format for other readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact::report {

/// Reals from `low` to `high` in so many steps: value = low + step · number, with whole numbers from 0 on, at most half a step off.
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

/// Packs the numbers of one array in picture after picture. Each time it takes, of six predictions, the one that leaves least:
///
///   0  nothing          3  what the element before was off by prediction 0
///   1  the picture before          4  the same of 1
///   2  a straight line through the two before     5  the same of 2
///
/// What is left (modulo 2^bits) is folded, 0 −1 1 −2 … → 0 1 2 3 …, and written as planes: all lowest bytes first.
class ArrayPacker {
 public:
  /// `bytes` of each number: 1, 2 or 4.
  explicit ArrayPacker(int bytes) : bytes_(bytes) {}

  /// Appends the number of the prediction (a byte) and the planes.
  void append(std::span<const std::uint32_t> numbers, std::string& out);

 private:
  int bytes_;
  std::vector<std::uint32_t> before_, before_that_;  // the last two pictures
};

/// A gzip file in memory (RFC 1952), equal for equal bytes.
std::string gzip(std::string_view bytes);

/// RFC 4648, section 4, on one line.
std::string base64(std::string_view bytes);

}  // namespace perimpact::report
