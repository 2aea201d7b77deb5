/// Sums over the slots of a boundary, by threads, in an order that does not depend on how many there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fccda/core/parallel.hpp"

namespace perimpact {

/// f(0) + f(1) + …, `count` of them: blocks in order, each summed in order. `f` may write what belongs to its number.
template <class Value, class F>
Value sum_in_blocks(std::size_t count, const F& f) {
  constexpr std::size_t block = 256;
  std::vector<Value> parts((count + block - 1) / block);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(parts.size()), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block, end = std::min(begin + block, count);
    Value part{};
    for (std::size_t k = begin; k < end; ++k) part += f(k);
    parts[static_cast<std::size_t>(b)] = part;
  });
  Value sum{};
  for (const Value& part : parts) sum += part;
  return sum;
}

/// Forces on particles: what they add up to, and how large they are.
struct ForceSum {
  fccda::Vec3d force{};  ///< [N]
  double squared = 0;    ///< [N²] Σ |F_i|²
  ForceSum& operator+=(const ForceSum& other) {
    force += other.force, squared += other.squared;
    return *this;
  }
};

}  // namespace perimpact
