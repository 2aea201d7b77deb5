/// Functions of packs beyond arithmetic and bits (pack.hpp), for kernels that have cases, bounds and roots. Unlike inverse_square_root() they are rounded
/// alike for every pack: a kernel that uses no others has bitwise the same results with each of them.
#pragma once

#include <cmath>

#include "base/pack.hpp"

namespace fccda {

FCCDA_HD inline double smaller(double a, double b) { return a < b ? a : b; }
FCCDA_HD inline double square_root(double a) { return std::sqrt(a); }
/// a in the lanes of the bits, b in the others.
FCCDA_HD inline double choose(unsigned bits, double a, double b) { return (bits & 1u) ? a : b; }

#if defined(__AVX512F__) && !defined(FCCDA_SCALAR_PACK)

inline Pack8 smaller(Pack8 a, Pack8 b) { return _mm512_min_pd(a.v, b.v); }
inline Pack8 square_root(Pack8 a) { return _mm512_sqrt_pd(a.v); }
inline Pack8 choose(unsigned bits, Pack8 a, Pack8 b) { return _mm512_mask_blend_pd(static_cast<__mmask8>(bits), b.v, a.v); }

#elif defined(__AVX2__) && defined(__FMA__) && !defined(FCCDA_SCALAR_PACK)

inline Pack4 smaller(Pack4 a, Pack4 b) { return _mm256_min_pd(a.v, b.v); }
inline Pack4 square_root(Pack4 a) { return _mm256_sqrt_pd(a.v); }
inline Pack4 choose(unsigned bits, Pack4 a, Pack4 b) {
  const __m256i lane = _mm256_set_epi64x(8, 4, 2, 1);
  const __m256i on = _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(static_cast<long long>(bits)), lane), lane);
  return _mm256_blendv_pd(b.v, a.v, _mm256_castsi256_pd(on));
}

#endif

}  // namespace fccda
