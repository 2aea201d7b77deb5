/// Peak rate of square roots with a division on one core: the reference for the bond loop.
///
/// Vector square root and division share one slow unit with a throughput of one operand per several cycles, which bounds any kernel that uses
/// them. The AVX-512 kernel computes 1/√ from an estimate and multiply-adds instead (base/pack.hpp), and may be faster.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/pack.hpp"

namespace benchmark {

inline double hardware_root(double a) { return std::sqrt(a); }
#if defined(__AVX512F__) && !defined(FCCDA_SCALAR_PACK)
inline constexpr const char* instruction_set = "AVX-512";
inline fccda::Pack8 hardware_root(fccda::Pack8 a) { return _mm512_sqrt_pd(a.v); }
#elif defined(__AVX2__) && defined(__FMA__) && !defined(FCCDA_SCALAR_PACK)
inline constexpr const char* instruction_set = "AVX2";
inline fccda::Pack4 hardware_root(fccda::Pack4 a) { return _mm256_sqrt_pd(a.v); }
#else
inline constexpr const char* instruction_set = "scalar";
#endif

/// Square roots with a division each, per second, on this core: the maximum of several attempts, since other load only reduces the rate.
inline double root_and_division_rate() {
  using Pack = fccda::NativePack;
  // x <- c/√x converges to c^(2/3), whose digits prevent early termination of the division. Eight chains hide the latency; twelve are no faster.
  constexpr int chains = 8, rounds = 200'000, attempts = 10;
  double best = 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Pack x[chains];
    for (int k = 0; k < chains; ++k) x[k] = Pack(1.1 + 0.1 * k);
    const Pack c(1.7);
    const auto begin = std::chrono::steady_clock::now();
    for (int round = 0; round < rounds; ++round)
#pragma GCC unroll 8
      for (int k = 0; k < chains; ++k) x[k] = c / hardware_root(x[k]);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const Pack& value : x) {
      volatile double sink[fccda::lanes<Pack>];  // keeps the results
      double lanes[fccda::lanes<Pack>];
      fccda::store(lanes, value);
      std::copy(std::begin(lanes), std::end(lanes), std::begin(sink));
    }
    best = std::max(best, chains * static_cast<double>(fccda::lanes<Pack>) * rounds / seconds);
  }
  return best;
}

}  // namespace benchmark
