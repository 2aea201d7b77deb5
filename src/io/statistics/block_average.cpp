#include "io/statistics/block_average.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace perimpact {

namespace {

/// Of independent values: their standard deviation over the root of their number.
double independent_standard_error(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (count * (count - 1)));
}

void halve(std::vector<double>& blocks) {
  for (std::size_t k = 0; k < blocks.size() / 2; ++k) blocks[k] = 0.5 * (blocks[2 * k] + blocks[2 * k + 1]);
  blocks.resize(blocks.size() / 2);
}

}  // namespace

std::optional<BlockAverage> block_average(std::span<const double> values) {
  if (values.size() < fewest_blocks) return std::nullopt;
  std::vector<double> blocks(values.begin(), values.end());
  const double of_values = independent_standard_error(blocks);
  BlockAverage largest{.standard_error = 0, .block = 1, .is_resolved = of_values == 0};
  if (of_values == 0) return largest;
  for (std::size_t block = 1; blocks.size() >= fewest_blocks; block *= 2, halve(blocks)) {
    const double error = independent_standard_error(blocks);
    if (std::pow(static_cast<double>(block), 3) > 2 * static_cast<double>(values.size()) * std::pow(std::max(1.0, error / of_values), 4))
      return BlockAverage{error, block, true};
    if (error > largest.standard_error) largest = {error, block, false};
  }
  return largest;
}

}  // namespace perimpact
