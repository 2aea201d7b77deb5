#include "io/statistics/block_average.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

/// x_n = memory x_(n-1) + white noise, in its stationary state of standard deviation 1.
std::vector<double> autoregressive(std::size_t count, double memory, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  values[0] = normal(random);
  for (std::size_t n = 1; n < count; ++n) values[n] = memory * values[n - 1] + std::sqrt(1 - memory * memory) * normal(random);
  return values;
}

}  // namespace

TEST_CASE("block average: of correlated records the standard error is the scatter of their means") {
  // variance of the mean of N values: (1 + memory)/((1 - memory) N) but for terms of the order of the correlation length over N
  constexpr std::size_t count = 20000;
  for (const double memory : {0.0, 0.5, 0.9, 0.97}) {
    CAPTURE(memory);
    double squares = 0;
    int resolved = 0;
    constexpr int records = 40;
    for (unsigned seed = 0; seed < records; ++seed) {
      const auto found = block_average(autoregressive(count, memory, seed));
      REQUIRE(found);
      resolved += found->is_resolved;
      squares += found->standard_error * found->standard_error / records;
    }
    CHECK(resolved == records);
    // blocks that end within the correlation leave some per cent, and the mean over 40 records of 30 blocks or more scatters by 4 %
    CHECK(std::sqrt(squares) == fixtures::relative(std::sqrt((1 + memory) / (1 - memory) / count), 0.12));
  }
}

TEST_CASE("block average: of independent values it is their deviation over the root of their number") {
  const auto found = block_average(autoregressive(100000, 0, 7));
  REQUIRE(found);
  CHECK(found->is_resolved);
  CHECK(found->block < 128);
  CHECK(found->standard_error == fixtures::relative(1 / std::sqrt(100000.0), 0.1));  // of more than 780 blocks: within 2.5 % in 68 % of records
}

TEST_CASE("block average: a record with a few slow cycles has a lower bound only") {
  std::vector<double> values(4000);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = std::sin(2 * std::numbers::pi * 1.7 * static_cast<double>(n) / 4000.0);
  const auto slow = block_average(values);
  REQUIRE(slow);
  CHECK_FALSE(slow->is_resolved);
  CHECK(slow->standard_error > 0.15);  // fifteen blocks deviate by 0.7 in the root mean square: 0.18
  std::iota(values.begin(), values.end(), 0.0);
  const auto rising = block_average(values);
  REQUIRE(rising);
  CHECK_FALSE(rising->is_resolved);
  CHECK(rising->block == 256);  // 15 blocks; the next length has seven
}

TEST_CASE("block average: a constant has no error, and fewer than eight values have none to give") {
  const auto constant = block_average(std::vector<double>(100, 3.5));
  REQUIRE(constant);
  CHECK(constant->standard_error == 0);
  CHECK(constant->is_resolved);
  CHECK_FALSE(block_average(std::vector<double>(7, 1.0)));
}
