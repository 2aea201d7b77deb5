/// Parallel sums over the slots of a boundary condition in a fixed order, bitwise reproducible across thread counts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec3.hpp"

namespace perimpact {

inline constexpr std::size_t sum_block = 256;

/// Calls f(begin, end, b) for the blocks b of 0 … count - 1, in parallel for many blocks.
template <class F>
void for_each_block(std::size_t count, const F& f) {
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>((count + sum_block - 1) / sum_block), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * sum_block;
    f(begin, std::min(begin + sum_block, count), static_cast<std::size_t>(b));
  });
}

/// f(0) + f(1) + …, `count` of them: blocks in order, each summed in order. `f` may write data of its index.
template <class Value, class F>
Value sum_in_blocks(std::size_t count, const F& f) {
  std::vector<Value> parts((count + sum_block - 1) / sum_block);
  for_each_block(count, [&](std::size_t begin, std::size_t end, std::size_t b) {
    Value part{};
    for (std::size_t k = begin; k < end; ++k) part += f(k);
    parts[b] = part;
  });
  Value sum{};
  for (const Value& part : parts) sum += part;
  return sum;
}

/// Resultant and 2-norm of forces on particles.
struct ForceSum {
  fccda::Vec3d force{};  ///< [N]
  double squared = 0;    ///< [N²] Σ |F_i|²
  ForceSum& operator+=(const ForceSum& other) {
    force += other.force, squared += other.squared;
    return *this;
  }
};

}  // namespace perimpact
