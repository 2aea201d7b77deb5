/// Packs of doubles (SIMD vectors). Kernels are written once, templated on the pack. The plain `double` is a pack of one particle;
/// tests use it as the reference for the wide packs, and it is the pack of a GPU, each of whose threads has one particle.
///
/// Packs have no mask type. The low bits of an integer select lanes, bit l for lane l, because a bond's state is stored as one bit.
/// `select` and `bits_where_greater` convert between both. With AVX-512 each is one instruction; with AVX2, an integer AND and a
/// comparison.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "base/host_device.hpp"

#if (defined(__AVX512F__) || defined(__AVX2__)) && !defined(FCCDA_SCALAR_PACK)
// GCC 12 warns of the deliberate use of an undefined register in its own header (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
#endif

namespace fccda {

/// Number of particles in one byte of bond bits: rows of particles are padded to this on every machine.
inline constexpr std::size_t byte_lanes = 8;
/// Number of eights of particles, pairs or slots; the last may be incomplete.
constexpr std::size_t eights_of(std::size_t count) { return (count + byte_lanes - 1) / byte_lanes; }
/// A number rounded up to complete eights.
constexpr std::size_t in_eights(std::size_t count) { return eights_of(count) * byte_lanes; }

template <class Pack>
inline constexpr std::size_t lanes = 1;

// One particle at a time.
template <class Pack>
requires std::is_same_v<Pack, double> FCCDA_HD double load(const double* from) { return *from; }
template <class Pack>
requires std::is_same_v<Pack, double> FCCDA_HD double gather(const double* from, const std::int32_t* index) {
  return from[*index];
}  ///< from[index[lane]] in each lane
/// Component c of row index[lane] in each lane of pack c; `rows` has four doubles each. On processors that gather slowly, several times as fast as four
/// times gather(), and a row is one half of a cache line.
template <class Pack>
requires std::is_same_v<Pack, double> FCCDA_HD std::array<double, 4> gather_rows(const double* rows, const std::int32_t* index) {
  const double* row = rows + 4 * static_cast<std::ptrdiff_t>(*index);
  return {row[0], row[1], row[2], row[3]};
}
FCCDA_HD inline void store(double* to, double a) { *to = a; }
FCCDA_HD inline double fused_multiply_add(double a, double b, double c) { return std::fma(a, b, c); }  ///< a·b + c, rounded once
FCCDA_HD inline double inverse_square_root(double a) { return 1 / std::sqrt(a); }
FCCDA_HD inline double length_of(double squared) { return std::sqrt(squared); }  ///< √a where 1/√a is not needed as well
FCCDA_HD inline double select(unsigned bits, double a) { return (bits & 1u) ? a : 0.0; }
FCCDA_HD inline unsigned bits_where_greater(double a, double b) { return a > b ? 1u : 0u; }
FCCDA_HD inline double larger(double a, double b) { return a > b ? a : b; }

/// Calls f(lane) for each set bit, in ascending order. On the host: nvcc compiles std::countr_zero() for a GPU without an error, but to wrong code.
template <class F>
void for_each_bit(unsigned bits, const F& f) {
  for (; bits != 0; bits &= bits - 1) f(static_cast<std::size_t>(std::countr_zero(bits)));
}

#if defined(__AVX512F__) && !defined(FCCDA_SCALAR_PACK)

/// Eight doubles in an AVX-512 register.
struct Pack8 {
  __m512d v;
  Pack8() : v(_mm512_setzero_pd()) {}
  Pack8(__m512d register_) : v(register_) {}
  Pack8(double all) : v(_mm512_set1_pd(all)) {}
  friend Pack8 operator+(Pack8 a, Pack8 b) { return _mm512_add_pd(a.v, b.v); }
  friend Pack8 operator-(Pack8 a, Pack8 b) { return _mm512_sub_pd(a.v, b.v); }
  friend Pack8 operator*(Pack8 a, Pack8 b) { return _mm512_mul_pd(a.v, b.v); }
  friend Pack8 operator/(Pack8 a, Pack8 b) { return _mm512_div_pd(a.v, b.v); }
  Pack8& operator+=(Pack8 b) { return *this = *this + b; }
  Pack8& operator-=(Pack8 b) { return *this = *this - b; }
  Pack8& operator*=(Pack8 b) { return *this = *this * b; }
};
using NativePack = Pack8;
template <>
inline constexpr std::size_t lanes<Pack8> = 8;

template <class Pack>
requires std::is_same_v<Pack, Pack8> Pack8 load(const double* from) { return _mm512_loadu_pd(from); }
template <class Pack>
requires std::is_same_v<Pack, Pack8> Pack8 gather(const double* from, const std::int32_t* index) {
  return _mm512_i32gather_pd(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)), from, 8);
}
template <class Pack>
requires std::is_same_v<Pack, Pack8>
[[gnu::always_inline]] inline std::array<Pack8, 4> gather_rows(const double* rows, const std::int32_t* index) {
  const auto pair = [&](std::size_t lane) {  // rows of this lane and of that four lanes on
    const __m512d low = _mm512_castpd256_pd512(_mm256_loadu_pd(rows + 4 * static_cast<std::ptrdiff_t>(index[lane])));
    return _mm512_insertf64x4(low, _mm256_loadu_pd(rows + 4 * static_cast<std::ptrdiff_t>(index[lane + 4])), 1);
  };
  const __m512d a = pair(0), b = pair(1), c = pair(2), d = pair(3);
  const __m512d even[] = {_mm512_unpacklo_pd(a, b), _mm512_unpacklo_pd(c, d)}, odd[] = {_mm512_unpackhi_pd(a, b), _mm512_unpackhi_pd(c, d)};
  const __m512i first = _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0), second = _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2);
  return {_mm512_permutex2var_pd(even[0], first, even[1]), _mm512_permutex2var_pd(odd[0], first, odd[1]), _mm512_permutex2var_pd(even[0], second, even[1]),
          _mm512_permutex2var_pd(odd[0], second, odd[1])};
}
inline void store(double* to, Pack8 a) { _mm512_storeu_pd(to, a.v); }
inline Pack8 fused_multiply_add(Pack8 a, Pack8 b, Pack8 c) { return _mm512_fmadd_pd(a.v, b.v, c.v); }
/// 1/√a to about one unit in the last place: the 14-bit estimate y, then y (1 + e/2 + 3e²/8 + 5e³/16) with e = 1 - a y²,
/// whose remainder is below 2⁻⁵³. Six multiply-adds replace a root and a division, which share one slow unit.
inline Pack8 inverse_square_root(Pack8 a) {
  const __m512d y = _mm512_rsqrt14_pd(a.v);
  const __m512d e = _mm512_fnmadd_pd(_mm512_mul_pd(a.v, y), y, _mm512_set1_pd(1.0));
  __m512d series = _mm512_fmadd_pd(e, _mm512_set1_pd(0.3125), _mm512_set1_pd(0.375));
  series = _mm512_fmadd_pd(e, series, _mm512_set1_pd(0.5));
  return _mm512_fmadd_pd(_mm512_mul_pd(y, e), series, y);
}
inline Pack8 length_of(Pack8 squared) { return squared * inverse_square_root(squared); }
inline Pack8 select(unsigned bits, Pack8 a) { return _mm512_maskz_mov_pd(static_cast<__mmask8>(bits), a.v); }
inline unsigned bits_where_greater(Pack8 a, Pack8 b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ); }
inline Pack8 larger(Pack8 a, Pack8 b) { return _mm512_max_pd(a.v, b.v); }

#elif defined(__AVX2__) && defined(__FMA__) && !defined(FCCDA_SCALAR_PACK)

/// Four doubles in an AVX register.
struct Pack4 {
  __m256d v;
  Pack4() : v(_mm256_setzero_pd()) {}
  Pack4(__m256d register_) : v(register_) {}
  Pack4(double all) : v(_mm256_set1_pd(all)) {}
  friend Pack4 operator+(Pack4 a, Pack4 b) { return _mm256_add_pd(a.v, b.v); }
  friend Pack4 operator-(Pack4 a, Pack4 b) { return _mm256_sub_pd(a.v, b.v); }
  friend Pack4 operator*(Pack4 a, Pack4 b) { return _mm256_mul_pd(a.v, b.v); }
  friend Pack4 operator/(Pack4 a, Pack4 b) { return _mm256_div_pd(a.v, b.v); }
  Pack4& operator+=(Pack4 b) { return *this = *this + b; }
  Pack4& operator-=(Pack4 b) { return *this = *this - b; }
  Pack4& operator*=(Pack4 b) { return *this = *this * b; }
};
using NativePack = Pack4;
template <>
inline constexpr std::size_t lanes<Pack4> = 4;

template <class Pack>
requires std::is_same_v<Pack, Pack4> Pack4 load(const double* from) { return _mm256_loadu_pd(from); }
template <class Pack>
requires std::is_same_v<Pack, Pack4> Pack4 gather(const double* from, const std::int32_t* index) {
  return _mm256_i32gather_pd(from, _mm_loadu_si128(reinterpret_cast<const __m128i*>(index)), 8);
}
template <class Pack>
requires std::is_same_v<Pack, Pack4>
[[gnu::always_inline]] inline std::array<Pack4, 4> gather_rows(const double* rows, const std::int32_t* index) {
  const auto row = [&](std::size_t lane) { return _mm256_loadu_pd(rows + 4 * static_cast<std::ptrdiff_t>(index[lane])); };
  const __m256d a = row(0), b = row(1), c = row(2), d = row(3);
  const __m256d even[] = {_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d)}, odd[] = {_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d)};
  return {_mm256_permute2f128_pd(even[0], even[1], 0x20), _mm256_permute2f128_pd(odd[0], odd[1], 0x20), _mm256_permute2f128_pd(even[0], even[1], 0x31),
          _mm256_permute2f128_pd(odd[0], odd[1], 0x31)};
}
inline void store(double* to, Pack4 a) { _mm256_storeu_pd(to, a.v); }
inline Pack4 fused_multiply_add(Pack4 a, Pack4 b, Pack4 c) { return _mm256_fmadd_pd(a.v, b.v, c.v); }
inline Pack4 inverse_square_root(Pack4 a) { return _mm256_div_pd(_mm256_set1_pd(1.0), _mm256_sqrt_pd(a.v)); }
inline Pack4 length_of(Pack4 squared) { return _mm256_sqrt_pd(squared.v); }
inline Pack4 select(unsigned bits, Pack4 a) {
  const __m256i lane = _mm256_set_epi64x(8, 4, 2, 1);
  const __m256i on = _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(static_cast<long long>(bits)), lane), lane);
  return _mm256_and_pd(_mm256_castsi256_pd(on), a.v);
}
inline unsigned bits_where_greater(Pack4 a, Pack4 b) { return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ))); }
inline Pack4 larger(Pack4 a, Pack4 b) { return _mm256_max_pd(a.v, b.v); }

#else
using NativePack = double;
#endif

/// The bits of the lanes of one pack, from a byte of eight lanes: lane 0 of the pack is lane `first` of the byte.
template <class Pack>
constexpr unsigned pack_bits(unsigned byte, std::size_t first) {
  return (byte >> first) & ((1u << lanes<Pack>)-1u);
}

}  // namespace fccda
