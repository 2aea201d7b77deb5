/// Loops over the slots of a boundary condition, and what it sums over them.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/vec3.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

/// Calls f(begin, end, b) for the blocks b of 0 … count - 1, in parallel for many blocks.
template <class F>
void for_each_block(std::size_t count, const F& f) {
  constexpr std::size_t block = 256;
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>((count + block - 1) / block), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block;
    f(begin, std::min(begin + block, count), static_cast<std::size_t>(b));
  });
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
