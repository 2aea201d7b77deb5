#include "base/exact_sum.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec3.hpp"
#include "fixtures/threads.hpp"

using namespace fccda;

namespace {

__extension__ using Wide = __int128;
__extension__ using Magnitude = unsigned __int128;

double sum_of(const std::vector<double>& numbers) {
  ExactSum sum;
  for (const double number : numbers) sum.add(number);
  return sum.value();
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Integer times 2^exponent, rounded once to nearest, ties to even: by division of integers, without floating-point operations. For normal results.
double rounded(Wide integer, int exponent) {
  const bool is_negative = integer < 0;
  auto magnitude = static_cast<Magnitude>(is_negative ? -integer : integer);
  int bits = 0;
  while (bits < 128 && (magnitude >> bits) != 0) ++bits;
  if (const int surplus = bits - 53; surplus > 0) {
    const auto unit = static_cast<Magnitude>(1) << surplus, rest = magnitude % unit;
    magnitude /= unit;
    if (2 * rest > unit || (2 * rest == unit && (magnitude & 1) != 0)) ++magnitude;
    exponent += surplus;
  }
  const double result = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(magnitude)), exponent);
  return is_negative ? -result : result;
}

/// Finite doubles of all exponents and both signs, subnormal ones among them.
double any_finite(std::mt19937_64& random) {
  while (true) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) return number;
  }
}

constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min(),
                 infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("exact sum: it is the integer sum of multiples of a power of two, rounded once") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20'000; ++trial) {
    // mantissas of 53 bits at exponents that differ by up to 66 fit into 127 bits with seven terms
    const int exponent = static_cast<int>(random() % 1900) - 1000;
    std::vector<double> numbers;
    Wide integer = 0;
    for (int k = 0; k < 7; ++k) {
      const auto mantissa = static_cast<std::int64_t>(random() >> 11) * (random() % 2 == 0 ? 1 : -1);
      const int shift = static_cast<int>(random() % 67);
      numbers.push_back(std::ldexp(static_cast<double>(mantissa), exponent + shift));
      integer += static_cast<Wide>(mantissa) * (static_cast<Wide>(1) << shift);
    }
    REQUIRE(same_bits(sum_of(numbers), rounded(integer, exponent)));
  }
}

TEST_CASE("exact sum: halfway cases go to the even number, and the smallest further term decides otherwise") {
  const double one_up = 1 + 0x1p-52;
  CHECK(sum_of({1, 0x1p-53}) == 1);
  CHECK(sum_of({one_up, 0x1p-53}) == 1 + 0x1p-51);
  CHECK(sum_of({1, 0x1p-53, least}) == one_up);
  CHECK(sum_of({one_up, 0x1p-53, -least}) == one_up);
  CHECK(sum_of({-1, -0x1p-53, -least}) == -one_up);
  CHECK(sum_of({0x1p700, 0x1p647, 0x1p-300}) == 0x1p700 * one_up);
}

TEST_CASE("exact sum: terms of all magnitudes that cancel leave exactly what remains") {
  CHECK(sum_of({largest, 1, -largest}) == 1);
  CHECK(sum_of({1e300, 1e-300, -1e300}) == 1e-300);
  CHECK(sum_of({largest, least, -largest}) == least);
  CHECK(sum_of({0.1, 0.2, -0.3}) == 0x1p-55);  // the nearest doubles, 3602879701896397 + 7205759403792794 - 10808639105689190 = 1 times 2^-55
  CHECK(same_bits(sum_of({1, -1}), 0.0));
  CHECK(same_bits(sum_of({-0.0, -0.0}), 0.0));
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const double remains = any_finite(random);
    std::vector<double> numbers{remains};
    for (int k = 0; k < 50; ++k) {
      const double number = any_finite(random);
      numbers.push_back(number), numbers.push_back(-number);
    }
    std::shuffle(numbers.begin(), numbers.end(), random);
    REQUIRE(same_bits(sum_of(numbers), remains));
  }
}

TEST_CASE("exact sum: subnormal numbers are added exactly, up to and beyond the smallest normal number") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    std::int64_t integer = 0;
    std::vector<double> numbers;
    for (int k = 0; k < 20; ++k) {
      const auto units = static_cast<std::int64_t>(random() >> 13) - (std::int64_t{1} << 50);
      numbers.push_back(std::ldexp(static_cast<double>(units), -1074));
      integer += units;
    }
    REQUIRE(same_bits(sum_of(numbers), rounded(integer, -1074)));  // fewer than 2⁵⁵ units: exact below 2⁵³
  }
}

TEST_CASE("exact sum: beyond the largest double it is infinite, and comes back with a term of the other sign") {
  CHECK(sum_of({largest, largest}) == infinity);
  CHECK(sum_of({-largest, -largest, -largest}) == -infinity);
  CHECK(sum_of({largest, largest, -largest}) == largest);
  CHECK(sum_of({largest, std::ldexp(1.0, 969)}) == largest);   // a quarter of the last place
  CHECK(sum_of({largest, std::ldexp(1.0, 970)}) == infinity);  // half of it: as the largest double is odd
  ExactSum sum;
  for (int k = 0; k < 32'768; ++k) sum.add(0x1p1023);
  CHECK(sum.value() == infinity);
  for (int k = 0; k < 32'767; ++k) sum.add(-0x1p1023);
  CHECK(sum.value() == 0x1p1023);
}

TEST_CASE("exact sum: infinities and NaN among the terms survive") {
  CHECK(sum_of({1, infinity, -1e308}) == infinity);
  CHECK(sum_of({-infinity, largest}) == -infinity);
  CHECK(std::isnan(sum_of({infinity, -infinity})));
  CHECK(std::isnan(sum_of({1, std::numeric_limits<double>::quiet_NaN(), infinity})));
  CHECK(std::isnan(sum_of({-std::numeric_limits<double>::quiet_NaN()})));
  ExactSum one, other;
  one.add(1), other.add(-infinity);
  one.add(other);
  CHECK(one.value() == -infinity);
}

TEST_CASE("exact sum: any order and any grouping of the terms give equal bits") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> exponent(0, 8);
  std::vector<double> numbers(3000);
  for (double& number : numbers) number = std::ldexp(std::bit_cast<double>(0x3ff0000000000000u | random() >> 12) - 1.5, static_cast<int>(exponent(random)));
  const double whole = sum_of(numbers);
  int ordinary_sums_that_differ = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::shuffle(numbers.begin(), numbers.end(), random);
    double ordinary = 0;
    for (const double number : numbers) ordinary += number;
    ordinary_sums_that_differ += ordinary != whole;
    std::vector<ExactSum> groups(1 + random() % 7);
    for (const double number : numbers) groups[random() % groups.size()].add(number);
    ExactSum merged;
    for (const ExactSum& group : groups) merged.add(group);
    REQUIRE(same_bits(sum_of(numbers), whole));
    REQUIRE(same_bits(merged.value(), whole));
  }
  CHECK(ordinary_sums_that_differ > 40);
}

TEST_CASE("exact sum: limbs that are added one by one are those of the sum of all terms") {
  std::mt19937_64 random(5);
  ExactSum all;
  std::array<std::int64_t, ExactSum::limb_count> limbs{};
  for (int process = 0; process < 64; ++process) {
    ExactSum own;
    for (int k = 0; k < 100; ++k) {
      const double number = any_finite(random) / 1024;
      own.add(number), all.add(number);
    }
    const auto its = own.limbs();
    for (std::size_t n = 0; n < limbs.size(); ++n) limbs[n] += its[n];
  }
  ExactSum total;
  std::ranges::copy(limbs, total.limbs().begin());
  CHECK(same_bits(total.value(), all.value()));
  // and it can be added to
  total.add(all.value()), all.add(all.value());
  CHECK(same_bits(total.value(), all.value()));
}

TEST_CASE("exact sum: carries are propagated before limbs overflow") {
  // 10⁷ terms of full limbs: 2⁵³ - 1 units of 2⁻⁵³ each
  const double almost_one = 1 - 0x1p-53;
  ExactSum sum, doubled;
  for (int k = 0; k < 10'000'000; ++k) sum.add(almost_one);
  CHECK(same_bits(sum.value(), rounded(static_cast<Wide>(10'000'000) * ((static_cast<Wide>(1) << 53) - 1), -53)));
  // doubled 32 times, more than 2⁵⁵ terms, beyond most_terms
  doubled = sum;
  for (int k = 0; k < 32; ++k) doubled.add(ExactSum(doubled));
  CHECK(same_bits(doubled.value(), std::ldexp(sum.value(), 32)));
  CHECK(doubled.value() > 1e7 * static_cast<double>(ExactSum::most_terms));
  // limbs of as many processes as may be added, all full, and further terms
  ExactSum of_process, all;
  for (int n = 30; n < 40; ++n) of_process.add(std::ldexp(4294967295.0, 32 * n - 1074));
  for (std::int64_t bit = 1; bit <= ExactSum::most_sums; bit *= 2) {  // most_sums = 1 + 2 + 4 + …
    all.add(of_process);
    of_process.add(ExactSum(of_process));
  }
  ExactSum total, one;
  for (int n = 30; n < 40; ++n) one.add(std::ldexp(4294967295.0, 32 * n - 1074));
  const auto limbs = one.limbs();
  std::ranges::transform(limbs, total.limbs().begin(), [](std::int64_t limb) { return ExactSum::most_sums * limb; });
  for (int n = 30; n < 40; ++n) {
    const double further = std::ldexp(almost_one, 32 * n - 1000);
    total.add(further), all.add(further);
  }
  CHECK(same_bits(total.value(), all.value()));
}

TEST_CASE("exact sums: the members of a struct are summed apart, and the number of threads does not matter") {
  std::mt19937_64 random(6);
  std::vector<Vec3d> vectors(100'000);
  ExactSum x, y, z;
  for (Vec3d& vector : vectors) {
    for (std::size_t c = 0; c < 3; ++c) vector[c] = any_finite(random) / 1e6;
    x.add(vector.x), y.add(vector.y), z.add(vector.z);
  }
  const Vec3d expected{x.value(), y.value(), z.value()};
  for (const int threads : {1, 2, 3}) {
    const fixtures::Threads with_several(threads);
    const Vec3d sum = exact_sum_of_shares<Vec3d>(1000, [&](std::ptrdiff_t share, ExactSums<Vec3d>& sums) {
                        for (std::size_t k = 0; k < 100; ++k) sums.add(vectors[100 * static_cast<std::size_t>(share) + k]);
                      }).value();
    CHECK(sum == expected);
    std::vector<double> numbers;
    for (const Vec3d& vector : vectors) numbers.push_back(vector.y);
    CHECK(exact_sum(numbers).value() == expected.y);
  }
}
