/// Standard error of the mean of a correlated record.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace perimpact {

inline constexpr std::size_t fewest_blocks = 8;  ///< the standard error of fewer blocks is itself uncertain by more than 27 %

struct BlockAverage {
  double standard_error;  ///< of the mean, in the unit of the values; a lower bound unless `is_resolved`
  std::size_t block;      ///< values per block
  bool is_resolved;       ///< blocks of this length are long enough to be independent
};

/// Block averaging (H. Flyvbjerg and H. G. Petersen, J. Chem. Phys. 91 (1989) 461): the standard error σ_B of the mean that would follow if the means of n
/// successive blocks of B values were independent,
///
///   σ_B² = Σ (x̄_k - x̄)²/(n (n - 1)),
///
/// grows with B until the blocks are longer than the correlation. B is the smallest power of two with B³ > 2 N max(1, σ_B/σ_1)⁴, which balances the remaining
/// correlation with the scatter of few blocks (R. M. Lee and others, Phys. Rev. E 83 (2011) 066706). If no block length with at least eight blocks satisfies
/// this, the record of N values is too short, and the largest σ_B is a lower bound. Values beyond the last whole block are not used.
///
/// None for fewer than eight values.
std::optional<BlockAverage> block_average(std::span<const double> values);

}  // namespace perimpact
