/// Exact sums of doubles: their order and grouping do not matter, so that the sum is bitwise identical for any number of threads and of processes.
///
/// The sum is an integer multiple of 2⁻¹⁰⁷⁴, the smallest double, in limbs of 32 bits (superaccumulator; R. M. Neal, Fast exact summation using small and
/// large superaccumulators, arXiv:1505.05571). Each limb is stored in 64 bits, so that carries are propagated only once in many additions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

namespace fccda {

/// Sum of doubles without rounding. An addition takes about as long as ten ordinary ones.
class ExactSum {
 public:
  static constexpr std::size_t digits = 67;              ///< limbs of the number; the last has the sign, and room for sums beyond the largest double
  static constexpr std::size_t limb_count = digits + 3;  ///< and counts of +∞, -∞ and NaN
  static constexpr std::int64_t most_terms = 1 << 29;    ///< between two propagations of carries
  static constexpr std::int64_t most_sums = 0x7fffffff;  ///< whose limbs may be added

  /// Adds a number; infinities and NaN too.
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t exponent = (bits >> 52) & 0x7ff, fraction = bits & 0xfffffffffffff;
    if (exponent == 0x7ff) [[unlikely]]
      return add_not_finite(value);
    if ((bits << 1) == 0) return;
    if (terms_ >= most_terms) [[unlikely]]
      carry();
    ++terms_;
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | (std::uint64_t{1} << 52), place = exponent == 0 ? 0 : exponent - 1;
    std::int64_t* limb = limbs_.data() + place / 32;
    const std::uint64_t low = (mantissa & 0xffffffff) << (place % 32), high = (mantissa >> 32) << (place % 32);
    const auto sign = -static_cast<std::int64_t>(bits >> 63);  // 0, or all bits set: (x ^ sign) - sign is x or -x
    const auto add_to = [&](std::size_t n, std::uint64_t part) { limb[n] += (static_cast<std::int64_t>(part) ^ sign) - sign; };
    add_to(0, low & 0xffffffff);
    add_to(1, (low >> 32) + (high & 0xffffffff));
    add_to(2, high >> 32);
  }

  /// Adds the terms of another sum.
  void add(const ExactSum& other) {
    if (terms_ + other.terms_ > most_terms) {
      carry();
      if (1 + other.terms_ > most_terms) {
        ExactSum carried = other;
        carried.carry();
        return add(carried);
      }
    }
    terms_ += other.terms_;
    for (std::size_t n = 0; n < limb_count; ++n) limbs_[n] += other.limbs_[n];
  }

  /// The sum, rounded once to the nearest double; ±∞ beyond the largest. With infinite terms ±∞, or NaN where both signs occur; NaN with a NaN.
  double value() const {
    ExactSum sum = *this;
    sum.carry();
    const auto& [positive, negative, not_a_number] = sum.count_of_not_finite();
    if (not_a_number > 0 || (positive > 0 && negative > 0)) return std::numeric_limits<double>::quiet_NaN();
    if (positive > 0 || negative > 0) return positive > 0 ? infinity : -infinity;
    const bool is_negative = sum.limbs_[digits - 1] < 0;
    if (is_negative) {
      for (std::size_t n = 0; n < digits; ++n) sum.limbs_[n] = -sum.limbs_[n];
      sum.carry();
    }
    const double magnitude = sum.magnitude();
    return is_negative ? -magnitude : magnitude;
  }

  /// Numbers that may be added to those of other sums, one by one, for up to `most_sums` sums: the results are limbs of the sum of all terms, to be written
  /// to those of one of the sums.
  std::span<std::int64_t, limb_count> limbs() {
    carry();
    terms_ = most_terms;  // they may grow: carries come first when more is added
    return limbs_;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void add_not_finite(double value) { ++limbs_[digits + (value == infinity ? 0 : value == -infinity ? 1 : 2)]; }
  std::array<std::int64_t, 3> count_of_not_finite() const { return {limbs_[digits], limbs_[digits + 1], limbs_[digits + 2]}; }

  /// Brings all limbs but the last into [0, 2³²).
  void carry() {
    for (std::size_t n = 0; n + 1 < digits; ++n) {
      limbs_[n + 1] += limbs_[n] >> 32;
      limbs_[n] &= 0xffffffff;
    }
    terms_ = 1;
  }

  /// Of a sum that is not negative, after propagation of carries.
  double magnitude() const {
    if (limbs_[digits - 1] != 0) return infinity;
    std::size_t top = digits - 2;
    while (top > 0 && limbs_[top] == 0) --top;
    const auto limb = [&](std::size_t n) { return static_cast<std::uint64_t>(limbs_[n]); };
    const std::uint64_t upper = limb(top) << 32 | (top > 0 ? limb(top - 1) : 0), lower = top > 1 ? limb(top - 2) : 0;
    if (upper == 0) return 0;
    // the leading 64 bits; the last of them is set where any bit below is, which rounds as all of them would
    const int shift = std::countl_zero(upper);
    std::uint64_t leading = upper << shift | lower >> (32 - shift);
    const bool has_more =
        (lower << shift & 0xffffffff) != 0 || std::any_of(limbs_.begin(), limbs_.begin() + std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(top) - 2),
                                                          [](std::int64_t below) { return below != 0; });
    if (has_more) leading |= 1;
    return std::ldexp(static_cast<double>(leading), 32 * (static_cast<int>(top) - 1) - shift - 1074);
  }

  std::array<std::int64_t, limb_count> limbs_{};
  std::int64_t terms_ = 0;  // |limb| <= 2³³ terms_ and terms_ <= most_terms; most_terms too where limbs may be those of other sums
};

/// Exact sums of the members of a struct, all of which are doubles, as of Vec3d; or of a double.
template <class Value>
class ExactSums {
  static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(double) == 0);
  using Numbers = std::array<double, sizeof(Value) / sizeof(double)>;

 public:
  /// Adds each member.
  void add(const Value& value) {
    const auto numbers = std::bit_cast<Numbers>(value);
    for (std::size_t n = 0; n < numbers.size(); ++n) sums_[n].add(numbers[n]);
  }
  /// Adds the terms of other sums.
  void add(const ExactSums& other) {
    for (std::size_t n = 0; n < sums_.size(); ++n) sums_[n].add(other.sums_[n]);
  }
  /// The sum of each member.
  std::span<ExactSum> of_members() { return sums_; }
  /// The sums, as ExactSum::value().
  Value value() const {
    Numbers numbers;
    for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] = sums_[n].value();
    return std::bit_cast<Value>(numbers);
  }

 private:
  std::array<ExactSum, std::tuple_size_v<Numbers>> sums_;
};

/// Exact sum of the terms that add(share, sums) adds to `sums` for share = 0 … count - 1, each called once, in parallel for many shares. `Value`: double, or
/// a struct of doubles.
template <class Value, class Add>
ExactSums<Value> exact_sum_of_shares(std::ptrdiff_t count, const Add& add) {
  ExactSums<Value> total;
#pragma omp parallel if (count > 8)
  {
    ExactSums<Value> own;
#pragma omp for schedule(dynamic, 8) nowait
    for (std::ptrdiff_t share = 0; share < count; ++share) add(share, own);
#pragma omp critical(fccda_exact_sum)
    total.add(own);
  }
  return total;
}

/// Exact sum of numbers.
inline ExactSums<double> exact_sum(std::span<const double> numbers) {
  constexpr std::size_t share_size = 1024;
  return exact_sum_of_shares<double>(static_cast<std::ptrdiff_t>((numbers.size() + share_size - 1) / share_size),
                                     [&](std::ptrdiff_t share, ExactSums<double>& sum) {
                                       const std::size_t first = static_cast<std::size_t>(share) * share_size;
                                       for (const double number : numbers.subspan(first, std::min(share_size, numbers.size() - first))) sum.add(number);
                                     });
}

}  // namespace fccda
